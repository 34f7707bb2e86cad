// The efficiency of a transmission by the powers that the ground sees.
#pragma once

#include <optional>

#include "mechanism/mechanism.hpp"
#include "power/power_graph.hpp"

namespace kinestat {

/// Every body shares the power that it effectively receives among its arcs and outlets as it would
/// without losses of meshes, and a lossy mesh keeps 1 - share of what enters it (Cazangi 2008,
/// section 4.4.4; solved as one linear system, so that power that circulates is counted to
/// the end). What then leaves by the outputs over what the inputs give: find_efficiency must have a
/// value for this flow. Empty where the powers of a body are open.
std::optional<double> find_absolute_efficiency(const Mechanism& mechanism,
                                               const Case& which,
                                               const PowerFlow& flow,
                                               const PowerGraph& graph);

}  // namespace kinestat
