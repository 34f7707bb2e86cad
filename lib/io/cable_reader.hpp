// The section `cables`.
#pragma once

#include <vector>

#include "core/diagnostic.hpp"
#include "description/cable_description.hpp"
#include "description/coupling_description.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

/// In file order; wrong ones are left out, with errors.
std::vector<CableDescription> read_cables(const YamlNode& node, Space space, Diagnostics& found);

}  // namespace kinestat
