// The section `losses`.
#pragma once

#include <optional>

#include "core/diagnostic.hpp"
#include "description/loss_description.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

/// Empty iff an error was added.
std::optional<LossDescription> read_losses(const YamlNode& node, Diagnostics& found);

}  // namespace kinestat
