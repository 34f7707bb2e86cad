// From a description to a mechanism in numbers.
#pragma once

#include <optional>

#include "core/diagnostic.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// Binds a description: evaluates every number and resolves every reference. Complains about
/// everything that makes no sense mechanically, then about what is not analysed yet
/// (find_unanalysed): E0315 if it decides the answer, else W0302. Warns of unused parameters. Empty
/// if an error was added, and for a file that holds only a synthesis task.
std::optional<Mechanism> bind(const MechanismDescription& description, Diagnostics& found);

/// The same for a pass that closes the drawn position itself. A coupling may have different points
/// on its two bodies; the geometry then has that of the tail.
std::optional<Mechanism> bind_unassembled(const MechanismDescription& description,
                                          Diagnostics& found);

/// Checks a description in the same way without making a mechanism; returns whether it is right.
/// What is not analysed yet is no error, only W0302.
bool check(const MechanismDescription& description, Diagnostics& found);

/// Binds the bodies and couplings with the freedoms and constraints that they have in space,
/// without cases: to count a planar mechanism as the spatial mechanism that it is.
std::optional<Mechanism> bind_in_space(const MechanismDescription& description, Diagnostics& found);

/// Whether a coupling of a planar mechanism has more freedoms in space than in the plane, as
/// contacts and cables have.
bool frees_more_in_space(const MechanismDescription& description);

}  // namespace kinestat
