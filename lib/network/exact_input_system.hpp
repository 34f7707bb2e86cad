// The node systems of the numbers as typed.
#pragma once

#include <span>
#include <vector>

#include "math/elimination/exact_input_elimination.hpp"
#include "mechanism/bind/exact_input_mechanism.hpp"
#include "screw/coordinate_basis.hpp"

namespace kinestat {

/// velocity_system without rounding, in a basis made of coordinates: unknowns and units are the
/// same.
ExactInputMatrix exact_input_velocity_system(const Topology& topology,
                                             const std::vector<ExactInputScrew>& motions,
                                             const CoordinateBasis& basis);

/// action_system likewise.
ExactInputMatrix exact_input_action_system(const Topology& topology,
                                           const std::vector<ExactInputScrew>& actions,
                                           const CoordinateBasis& basis);

/// load_vector likewise: one a load of the case, as typed.
std::vector<ExactInput> exact_input_load_vector(int body_count,
                                                const CoordinateBasis& basis,
                                                std::span<const Load> loads,
                                                const std::vector<ExactInputScrew>& wrenches);

/// As many as any matrix with entries at these places can have.
int largest_rank(const ExactInputMatrix& matrix);
int largest_rank(const SparseMatrix& matrix);

}  // namespace kinestat
