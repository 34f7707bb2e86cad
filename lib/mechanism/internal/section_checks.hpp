// All sections beside bodies, couplings, actuators and cases: their numbers and references.
#pragma once

#include "mechanism/internal/evaluator.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// Evaluates every number of the masses of bodies, of `gravity`, `gears`, `cables`, `loads` (of
/// cases too), `losses`, `shift`, `motion`, `sweep` and `synthesis`, resolves every reference, and
/// complains of what is wrong without any analysis.
void check_sections(const MechanismDescription& description,
                    Evaluator& evaluator,
                    Diagnostics& found);

/// Complains of the freedoms and actions that `motion` and `sweep` report although their couplings
/// do not have them. The topology must hold all couplings, those of gears and cables too.
void check_reported_quantities(const MechanismDescription& description,
                               const Topology& topology,
                               Diagnostics& found);

}  // namespace kinestat
