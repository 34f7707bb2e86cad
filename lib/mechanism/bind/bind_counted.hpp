// Files without dimensions: a published topology that can be counted, but not analysed.
#pragma once

#include <optional>

#include "core/diagnostic.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// Whether some coupling lacks the place that its type needs.
bool can_only_be_counted(const MechanismDescription& description);

/// Whether the file gives the directions of the axes of its couplings, though not their places.
bool knows_directions(const MechanismDescription& description);

/// The mechanism with the freedoms of its own space, and the same with those in space. Both have
/// bodies, couplings and graph, but no cases. Screws without a place go through the origin: only
/// their numbers have a meaning, and their directions if these are known.
struct CountedMechanism {
  Mechanism mechanism;
  Mechanism in_space;
};

/// Binds a file for counting. Complains as `check` does, and of what decides the counts but is not
/// analysed (E0315). Empty iff an error was added.
std::optional<CountedMechanism> bind_counted(const MechanismDescription& description,
                                             Diagnostics& found);

}  // namespace kinestat
