// How pictures are called.
#pragma once

#include <string>
#include <string_view>

#include "description/mechanism_description.hpp"
#include "report/analysis.hpp"

namespace kinestat {

/// "Shift matrix: Ravigneaux transmission"; the file stands for a mechanism without a name.
std::string picture_title(std::string_view what,
                          const std::string& file,
                          const MechanismDescription& description);
std::string picture_title(std::string_view what, const Analysis& analysis);

}  // namespace kinestat
