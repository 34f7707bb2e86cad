// The curves of a description in numbers.
#pragma once

#include <vector>

#include "mechanism/check/section_context.hpp"
#include "mechanism/curves/curve.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// Evaluates them and complains of what is wrong; one that is wrong has no points. `topology` is
/// null where the structure is not bound, and then no freedom is found.
std::vector<Curve> bind_curves(const SectionContext& context, const Topology* topology);

/// W0301 for each that no load, action, spring or drive names.
void warn_of_unused_curves(const MechanismDescription& description, Diagnostics& found);

}  // namespace kinestat
