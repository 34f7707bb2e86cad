// The section `sweep`.
#pragma once

#include <optional>

#include "core/diagnostic.hpp"
#include "description/sweep_description.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

/// Empty iff an error was added.
std::optional<SweepDescription> read_sweep(const YamlNode& node, Diagnostics& found);

}  // namespace kinestat
