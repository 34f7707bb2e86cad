// The springs of a description in numbers.
#pragma once

#include <span>
#include <vector>

#include "mechanism/check/section_context.hpp"
#include "mechanism/curves/curve.hpp"
#include "mechanism/springs/spring.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// Resolves what springs join and evaluates them, places from the origin of the evaluator.
/// Complains of what is wrong; `topology` is null where the structure is not bound, and only names
/// and numbers are looked at.
std::vector<Spring> bind_springs(const SectionContext& context,
                                 const Topology* topology,
                                 std::span<const Curve> curves);

}  // namespace kinestat
