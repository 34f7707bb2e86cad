// The section `motion`.
#pragma once

#include <optional>

#include "core/diagnostic.hpp"
#include "description/coupling_description.hpp"
#include "description/motion_description.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

/// Empty iff an error was added.
std::optional<MotionDescription> read_motion(const YamlNode& node, Space space, Diagnostics& found);

}  // namespace kinestat
