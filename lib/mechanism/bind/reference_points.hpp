// Where the velocities of bodies are reported.
#pragma once

#include <vector>

#include "mechanism/bind/evaluator.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// Of each body of the topology [m]: the point that its description gives, else that of its first
/// coupling that has one, as drawn on the body, else the origin of the geometry. `has_point` says
/// which couplings of the topology have a point of their own. `Scalar` is double or Dual.
template <class Scalar>
std::vector<Vec3Of<Scalar>> bind_reference_points(const MechanismDescription& description,
                                                  const std::vector<bool>& has_point,
                                                  const Topology& topology,
                                                  const GeometryOf<Scalar>& geometry,
                                                  EvaluatorOf<Scalar>& evaluator);

}  // namespace kinestat
