// The key `friction` of a coupling.
#pragma once

#include <optional>
#include <string_view>

#include "core/diagnostic.hpp"
#include "description/friction_description.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

/// A coefficient, or a mapping. Empty iff an error was added.
std::optional<FrictionDescription> read_friction(const YamlNode& node,
                                                 std::string_view what,
                                                 Diagnostics& found);

}  // namespace kinestat
