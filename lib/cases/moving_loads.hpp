// Loads of a case that depend on the position and motion of the mechanism.
#pragma once

#include <optional>

#include "cases/analysis.hpp"

namespace kinestat {

/// Adds to a case whose motion is solved what depends on the position of the mechanism: the loads
/// and actions that follow curves, and the forces of springs. If one has no value, the case gets
/// the obstacle. `place` is null for the drawn position.
void add_placed_loads(const Mechanism& mechanism, const LoadState* place, CaseAnalysis& one);

/// How a solved case with inertia moves in the drawn position. Empty if its accelerations cannot be
/// found: the actions are then not known.
std::optional<InertialMotion> drawn_inertial_motion(const Mechanism& mechanism, CaseAnalysis& one);

/// Adds the inertia forces of that motion.
void add_inertial_loads(const Mechanism& mechanism,
                        const InertialMotion& motion,
                        CaseAnalysis& one);

/// Whether all loads and actions of a solved case are numbers as typed: all loads that were added
/// to `given` are zero, and no action follows curves. `given` is the case before it was solved.
bool has_typed_loads(const Case& given, const Case& solved);

}  // namespace kinestat
