// Loads of a case that follow from how the mechanism stands and moves.
#pragma once

#include <optional>

#include "cases/analysis.hpp"

namespace kinestat {

/// Gives a case whose motion is solved what hangs on where the mechanism stands: loads and actions
/// that follow curves and the forces of springs, unless nothing can be said of one. `place` is
/// null as drawn with the speeds of the case.
void add_placed_loads(const Mechanism& mechanism, const LoadState* place, CaseAnalysis& one);

/// Adds the forces of inertia of a case that has them; `known` is how the bodies speed up, null
/// as drawn. Empty where that is not known: then nothing can be said of the actions.
std::optional<InertialMotion> add_inertial_loads(const Mechanism& mechanism,
                                                 const InertialMotion* known,
                                                 CaseAnalysis& one);

/// Whether no such load does anything and no action moves, of which numbers as typed know nothing;
/// `given` is the case without them.
bool has_typed_loads(const Case& given, const Case& solved);

}  // namespace kinestat
