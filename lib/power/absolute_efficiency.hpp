// The efficiency of a transmission by the powers as seen from the ground.
#pragma once

#include <optional>

#include "mechanism/mechanism.hpp"
#include "power/power_graph.hpp"

namespace kinestat {

/// Finds the power that leaves at the outputs over the power that the inputs give (Cazangi 2008,
/// section 4.4.4). Every body divides the power that it receives among its arcs and outlets in the
/// same proportions as without mesh losses; what one actuator gives another on the same coupling
/// passes through the body at its head. A lossy mesh passes on 1 - share of the power that enters
/// it. This is solved as one linear system, so that circulating power is counted to the end.
/// find_efficiency must have a value for this flow. Empty if the powers of a body are open.
std::optional<double> find_absolute_efficiency(const Mechanism& mechanism,
                                               const Case& which,
                                               const PowerFlow& flow,
                                               const PowerGraph& graph);

}  // namespace kinestat
