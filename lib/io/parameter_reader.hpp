// The sections `units` and `parameters`.
#pragma once

#include <vector>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

/// Changes the units that the section names.
void read_units(const YamlNode& node, FileUnits& units, Diagnostics& found);

/// In file order; wrong ones are left out, with errors.
std::vector<ParameterDescription> read_parameters(const YamlNode& node, Diagnostics& found);

}  // namespace kinestat
