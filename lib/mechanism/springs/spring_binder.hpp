// The springs of a description, bound to numbers.
#pragma once

#include <span>
#include <vector>

#include "mechanism/check/section_context.hpp"
#include "mechanism/curves/curve.hpp"
#include "mechanism/springs/spring.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// Binds the springs and adds errors. Places are measured from the origin of the evaluator.
/// `topology` is null if the structure is not bound; only names and numbers are then checked.
std::vector<Spring> bind_springs(const SectionContext& context,
                                 const Topology* topology,
                                 std::span<const Curve> curves);

}  // namespace kinestat
