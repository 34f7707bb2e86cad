// The section `loads`, at the top level or in a case.
#pragma once

#include <vector>

#include "core/diagnostic.hpp"
#include "description/coupling_description.hpp"
#include "description/load_description.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

/// In file order; wrong ones are left out, with errors.
std::vector<LoadDescription> read_loads(const YamlNode& node, Space space, Diagnostics& found);

}  // namespace kinestat
