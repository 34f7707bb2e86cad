// The reference points of bodies, at which their velocities are reported.
#pragma once

#include <vector>

#include "mechanism/bind/evaluator.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// Finds the reference point of each body of the topology [m]: the point that its description
/// gives, else that of its first coupling with a point, as drawn on the body, else the origin of
/// the geometry. `has_point` says which couplings have a point. `Scalar` is double or Dual.
template <class Scalar>
std::vector<Vec3Of<Scalar>> bind_reference_points(const MechanismDescription& description,
                                                  const std::vector<bool>& has_point,
                                                  const Topology& topology,
                                                  const GeometryOf<Scalar>& geometry,
                                                  EvaluatorOf<Scalar>& evaluator);

}  // namespace kinestat
