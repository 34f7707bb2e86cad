// The curves of a description, bound to numbers.
#pragma once

#include <vector>

#include "mechanism/check/section_context.hpp"
#include "mechanism/curves/curve.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// Evaluates the curves and adds errors; a wrong curve has no points. `topology` is null if the
/// structure is not bound; curves then have no freedom.
std::vector<Curve> bind_curves(const SectionContext& context, const Topology* topology);

/// Adds W0301 for each curve that no load, action, spring or drive uses.
void warn_of_unused_curves(const MechanismDescription& description, Diagnostics& found);

}  // namespace kinestat
