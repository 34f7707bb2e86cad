// The parameters of a file, for whoever types their names.
#pragma once

#include <string>
#include <vector>

#include "description/mechanism_description.hpp"

namespace kinestat {

/// In the order of the file.
std::vector<std::string> parameter_names(const MechanismDescription& description);

/// What to type instead of a name that no parameter has; `value` is what it was to have.
std::string parameter_hint(const std::string& name,
                           const MechanismDescription& description,
                           const std::string& value = "VALUE");

}  // namespace kinestat
