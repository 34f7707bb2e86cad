// Files without dimensions: a published topology that can be counted, but not analysed.
#pragma once

#include <optional>

#include "core/diagnostic.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// Whether some coupling lacks the place that its type needs.
bool can_only_be_counted(const MechanismDescription& description);

/// Whether the file says along which axes its couplings turn and slide, though not where.
bool knows_directions(const MechanismDescription& description);

/// Bodies, couplings and graph with the freedoms of the file's own space, and the same in space.
/// Screws go through the origin where the file has no place: only their numbers mean anything, and
/// their directions if these are known. There are no cases.
struct CountedMechanism {
  Mechanism mechanism;
  Mechanism in_space;
};

/// Complains as `check` does, and of what decides the counts and has no analysis (E0315). Empty iff
/// an error was added.
std::optional<CountedMechanism> bind_counted(const MechanismDescription& description,
                                             Diagnostics& found);

}  // namespace kinestat
