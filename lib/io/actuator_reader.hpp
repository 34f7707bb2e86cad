// The section `actuators`.
#pragma once

#include <vector>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

/// In file order; wrong ones are left out, with errors.
std::vector<ActuatorDescription> read_actuators(const YamlNode& node, Diagnostics& found);

}  // namespace kinestat
