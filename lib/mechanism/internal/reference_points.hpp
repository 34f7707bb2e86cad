// Where the velocities of bodies are reported, and how large the mechanism is.
#pragma once

#include <vector>

#include "mechanism/internal/evaluator.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// Of each body of the topology [m]: the point that its description gives, else the point of its
/// first coupling. `points` are those of the couplings.
std::vector<Vec3> bind_reference_points(const MechanismDescription& description,
                                        const Topology& topology,
                                        const std::vector<Vec3>& points,
                                        Evaluator& evaluator);

/// The diagonal of the box around all points [m]; 1 if they coincide or there are none.
double characteristic_length(const std::vector<Vec3>& points);

}  // namespace kinestat
