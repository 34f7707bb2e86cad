// The hand of helical teeth that the file writes as a coupling.
#pragma once

#include <span>

#include "couplings/coupling_geometry.hpp"
#include "mechanism/bind/direction_binder.hpp"
#include "mechanism/gears/hinge_lines.hpp"

namespace kinestat {

/// Whether the hand of teeth is told by their tangent.
bool has_helix_by_tangent(const CouplingDescription& coupling);

/// Adds E0305 where axis x tangent points from the teeth to the axis of their tail, not outwards:
/// the helix angle would then be that of the other hand. Nothing is known where the tail hangs on
/// more than hinges about one axis and teeth. `lines` are those of all hinges.
void check_hand(const CouplingDescription& coupling,
                const CouplingGeometry& geometry,
                const Topology& topology,
                BodyId tail,
                std::span<const HingeLine> lines,
                const Evaluator& evaluator,
                Diagnostics& found);

}  // namespace kinestat
