// From a description to a mechanism in numbers.
#pragma once

#include <optional>

#include "core/diagnostic.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// Evaluates every number and resolves every reference; complains about everything that makes no
/// sense mechanically. Empty iff an error was added. Warns of unused parameters.
std::optional<Mechanism> bind(const MechanismDescription& description, Diagnostics& found);

/// The same bodies and couplings with the constraints that they have in space, without cases: for
/// counting a planar mechanism as the spatial one that it is.
std::optional<Mechanism> bind_in_space(const MechanismDescription& description, Diagnostics& found);

}  // namespace kinestat
