// From a description to a mechanism in numbers.
#pragma once

#include <optional>

#include "core/diagnostic.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// Evaluates every number and resolves every reference; complains about everything that makes no
/// sense mechanically, and then about what has no analysis yet (find_unanalysed): E0315 if it
/// decides the answer, else W0302. Empty if an error was added, and for a file that holds only a
/// synthesis task. Warns of unused parameters.
std::optional<Mechanism> bind(const MechanismDescription& description, Diagnostics& found);

/// The same for a pass that closes the drawn position itself: points that differ on the two bodies
/// of a coupling are no error, and the geometry has that of the tail.
std::optional<Mechanism> bind_unassembled(const MechanismDescription& description,
                                          Diagnostics& found);

/// The same without the mechanism: whether the description is right. What has no analysis yet is
/// no error, only W0302.
bool check(const MechanismDescription& description, Diagnostics& found);

/// The same bodies and couplings with the freedoms and constraints that they have in space, without
/// cases: for counting a planar mechanism as the spatial one that it is.
std::optional<Mechanism> bind_in_space(const MechanismDescription& description, Diagnostics& found);

/// Whether a coupling of a planar mechanism frees more in space than in the plane, as contacts and
/// cables do.
bool frees_more_in_space(const MechanismDescription& description);

}  // namespace kinestat
