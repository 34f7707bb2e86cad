// The key `friction` of a coupling.
#pragma once

#include <optional>
#include <string_view>

#include "core/diagnostic.hpp"
#include "description/friction_description.hpp"
#include "io/yaml_tree.hpp"

namespace kinestat {

/// Where friction acts, and with it which keys may stand.
enum class FrictionKind {
  journal,   ///< mu with radius, thrust_radius, length, tau, c; of revolute
  thread,    ///< mu with radius, tau, c; of helical
  guide,     ///< mu, length, radius, c; of prismatic
  sliding,   ///< mu; of contacts and teeth
  whatever,  ///< all; of types whose friction has no law yet
};

/// A mapping or, but for a journal or thread, a coefficient alone. Empty iff an error was added.
std::optional<FrictionDescription> read_friction(const YamlNode& node,
                                                 FrictionKind kind,
                                                 std::string_view what,
                                                 Diagnostics& found);

}  // namespace kinestat
