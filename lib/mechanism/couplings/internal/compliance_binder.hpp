// The compliance of actions, from the stiffness of couplings.
#pragma once

#include <vector>

#include "core/diagnostic.hpp"
#include "mechanism/bind/evaluator.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// Of each action [m/N or rad/(N·m)]: 1 by its stiffness; 0, which is rigid, where there is none.
/// The names and numbers must have been checked with the structure. `Scalar` is double or Dual.
template <class Scalar>
std::vector<Scalar> bind_compliances(const MechanismDescription& description,
                                     const Topology& topology,
                                     EvaluatorOf<Scalar>& evaluator);

/// Warns of stiffness that nothing uses, and of a section `statics` that finds none.
void warn_of_idle_stiffness(const MechanismDescription& description, Diagnostics& found);

}  // namespace kinestat
