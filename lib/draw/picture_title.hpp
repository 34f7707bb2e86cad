// How pictures are called.
#pragma once

#include <string>
#include <string_view>

#include "cases/analysis.hpp"
#include "description/mechanism_description.hpp"

namespace kinestat {

/// The name of the mechanism or, without one, of its file; "<stdin>" for standard input.
std::string shown_name(const std::string& file, const MechanismDescription& description);

/// "Shift matrix: Ravigneaux transmission".
std::string picture_title(std::string_view what,
                          const std::string& file,
                          const MechanismDescription& description);
std::string picture_title(std::string_view what, const Analysis& analysis);

}  // namespace kinestat
