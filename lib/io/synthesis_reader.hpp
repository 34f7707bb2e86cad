// The section `synthesis`, whose points are always in a plane.
#pragma once

#include <optional>

#include "core/diagnostic.hpp"
#include "description/synthesis_description.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

/// Empty iff an error was added.
std::optional<SynthesisDescription> read_synthesis(const YamlNode& node, Diagnostics& found);

}  // namespace kinestat
