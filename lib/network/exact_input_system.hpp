// The node systems written with the numbers as typed, without rounding.
#pragma once

#include <span>
#include <vector>

#include "math/elimination/exact_input_elimination.hpp"
#include "mechanism/bind/exact_input_mechanism.hpp"
#include "screw/coordinate_basis.hpp"

namespace kinestat {

/// velocity_system without rounding, with the same unknowns and units. `basis` must consist of
/// coordinates.
ExactInputMatrix exact_input_velocity_system(const Topology& topology,
                                             const std::vector<ExactInputScrew>& motions,
                                             const CoordinateBasis& basis);

/// action_system without rounding.
ExactInputMatrix exact_input_action_system(const Topology& topology,
                                           const std::vector<ExactInputScrew>& actions,
                                           const CoordinateBasis& basis);

/// load_vector without rounding. `wrenches` are those of the loads as typed, one per load.
std::vector<ExactInput> exact_input_load_vector(int body_count,
                                                const CoordinateBasis& basis,
                                                std::span<const Load> loads,
                                                const std::vector<ExactInputScrew>& wrenches);

/// The largest rank that a matrix with entries in these places can have, whatever their values.
int largest_rank(const ExactInputMatrix& matrix);
int largest_rank(const SparseMatrix& matrix);

}  // namespace kinestat
