// The section `shift`.
#pragma once

#include <optional>

#include "core/diagnostic.hpp"
#include "description/shift_description.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

/// Empty iff an error was added.
std::optional<ShiftDescription> read_shift(const YamlNode& node, Diagnostics& found);

}  // namespace kinestat
