// The section `units`.
#pragma once

#include "core/diagnostic.hpp"
#include "expression/file_units.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

/// Changes the units that the section names.
void read_units(const YamlNode& node, FileUnits& units, Diagnostics& found);

}  // namespace kinestat
