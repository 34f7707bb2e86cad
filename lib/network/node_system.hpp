// The sparse equations at bodies and couplings that the passes solve.
#pragma once

#include <span>
#include <vector>

#include "math/elimination/sparse_matrix.hpp"
#include "mechanism/cases/load.hpp"
#include "mechanism/geometry.hpp"
#include "mechanism/topology.hpp"
#include "screw/coordinate_basis.hpp"

namespace kinestat {

/// Unknowns count in the units of the basis: angular velocities and forces in SI, what holds a
/// length in the mechanism's size. So the numbers, and with them the rank, do not depend on it.

/// Velocities: for every coupling t_head - t_tail - Σ φ_i $_i = 0, in the coordinates of `basis`.
/// Rows: order · e. Columns: the twists of bodies 1, 2, … (order each; the ground rests), then the
/// freedoms. Its rank is order·(n - 1) + rank M_N.
SparseMatrix velocity_system(const Topology& topology,
                             const Geometry& geometry,
                             const CoordinateBasis& basis);

/// The column of a freedom in the velocity system.
int velocity_column(const Topology& topology, const CoordinateBasis& basis, int freedom);

/// SI per unit of the unknown of a freedom: 1 for a rotation, the length unit for a translation.
double rate_unit(const Topology& topology, const CoordinateBasis& basis, int freedom);

/// Those of all freedoms.
std::vector<double> rate_units(const Topology& topology, const CoordinateBasis& basis);

/// The twist of a body [SI] from a solution of the velocity system; zero for the ground.
Twist body_twist(const VecX& solution, const CoordinateBasis& basis, BodyId body);

/// Equilibrium: for every body but the ground, the actions of couplings on it, tail on head
/// positive, and the loads on it sum to zero. Rows: order · (n - 1). Columns: the actions. Its rank
/// is rank A_N.
SparseMatrix action_system(const Topology& topology,
                           const Geometry& geometry,
                           const CoordinateBasis& basis);

/// The right-hand side of the action system: minus the wrenches on the bodies, which `basis` must
/// hold; those on the ground do not count. Empty, which stands for zero, if there are no loads.
/// `body_count` includes the ground.
std::vector<double> load_vector(int body_count,
                                const CoordinateBasis& basis,
                                std::span<const BodyWrench> loads);

/// SI per unit of the unknown of an action: 1 for a force, the length unit for a couple.
double action_unit(const Topology& topology, const CoordinateBasis& basis, int action);

/// Those of all actions.
std::vector<double> action_units(const Topology& topology, const CoordinateBasis& basis);

}  // namespace kinestat
