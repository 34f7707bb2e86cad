// The section `gears`.
#pragma once

#include <optional>

#include "core/diagnostic.hpp"
#include "description/gear_description.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

/// Empty iff an error was added.
std::optional<GearsDescription> read_gears(const YamlNode& node, Diagnostics& found);

}  // namespace kinestat
