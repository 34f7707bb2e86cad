// The other flanks of teeth that the file writes as couplings, in numbers of any type.
#pragma once

#include <vector>

#include "description/mechanism_description.hpp"
#include "mechanism/gears/tooth_flanks.hpp"

namespace kinestat {

/// The teeth of the file that turn with their load. All couplings must have become those of the
/// topology.
std::vector<TurningTeeth> find_turning_teeth(const MechanismDescription& description,
                                             const Topology& topology,
                                             const Geometry& geometry);

/// The forces of teeth that should turn, but whose other flank is not known: they touch only, or no
/// hinge says in which plane they roll. To be asked once the flanks are complete.
std::vector<int> find_one_flanked(const MechanismDescription& description,
                                  const Topology& topology,
                                  const Geometry& geometry);

/// Completes the other flanks of a geometry with all screws, in the order of their actions: adds
/// those that follow from a rule, and puts the flank that pushes under a positive force first. So
/// teeth of a file press where those of `gears` do. `Scalar` is double, Dual or ExactInput.
template <class Scalar>
void complete_flanks(const std::vector<ToothRule>& rules,
                     const Topology& topology,
                     GeometryOf<Scalar>& geometry);

}  // namespace kinestat
