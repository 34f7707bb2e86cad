// A description as the text of a mechanism file.
#pragma once

#include <span>
#include <string>

#include "description/mechanism_description.hpp"

namespace kinestat {

/// The file that reads back as the description. `head` are the comment lines before it; what
/// cannot be printed in them and in the names stands as \xNN.
std::string mechanism_text(const MechanismDescription& description,
                           std::span<const std::string> head);

}  // namespace kinestat
