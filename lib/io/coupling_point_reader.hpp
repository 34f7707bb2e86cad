// Where a coupling is: the key `at`.
#pragma once

#include <optional>
#include <string_view>

#include "core/diagnostic.hpp"
#include "description/coupling_description.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

/// A point, a mapping of both bodies to a point each, or a number along the axis. Empty iff an
/// error was added.
std::optional<CouplingPoint> read_coupling_point(const YamlNode& node,
                                                 std::string_view what,
                                                 Space space,
                                                 Diagnostics& found);

}  // namespace kinestat
