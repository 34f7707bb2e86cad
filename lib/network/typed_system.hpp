// The node systems of the numbers as typed.
#pragma once

#include <span>
#include <vector>

#include "math/elimination/typed_elimination.hpp"
#include "mechanism/bind/typed_mechanism.hpp"
#include "screw/coordinate_basis.hpp"

namespace kinestat {

/// velocity_system without rounding, in a basis made of coordinates: unknowns and units are the
/// same.
TypedMatrix typed_velocity_system(const Topology& topology,
                                  const std::vector<TypedScrew>& motions,
                                  const CoordinateBasis& basis);

/// action_system likewise.
TypedMatrix typed_action_system(const Topology& topology,
                                const std::vector<TypedScrew>& actions,
                                const CoordinateBasis& basis);

/// load_vector likewise: one a load of the case, as typed.
std::vector<Typed> typed_load_vector(int body_count,
                                     const CoordinateBasis& basis,
                                     std::span<const Load> loads,
                                     const std::vector<TypedScrew>& wrenches);

/// As many as any matrix with entries at these places can have.
int largest_rank(const TypedMatrix& matrix);
int largest_rank(const SparseMatrix& matrix);

}  // namespace kinestat
