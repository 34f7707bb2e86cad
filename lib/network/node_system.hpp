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

/// Unknowns are in the units of the basis: angular velocities and forces in SI; in quantities that
/// contain a length, the size of the mechanism is the unit of length. So neither the numbers nor
/// the rank depend on this size.

/// The equations of velocities, in the coordinates of `basis`: t_head - t_tail - Σ φ_i $_i = 0 for
/// every coupling. Rows: `order` for each coupling. Columns: `order` for the twist of each of the
/// bodies 1, 2, … (the ground is at rest), then one for each freedom. The rank is
/// order·(n - 1) + rank M_N for n bodies.
SparseMatrix velocity_system(const Topology& topology,
                             const Geometry& geometry,
                             const CoordinateBasis& basis);

/// The column of a freedom in the velocity system.
int velocity_column(const Topology& topology, const CoordinateBasis& basis, int freedom);

/// SI per unit of the unknown of a freedom: 1 for a rotation, the length unit for a translation.
double rate_unit(const Topology& topology, const CoordinateBasis& basis, int freedom);

/// The units of all freedoms.
std::vector<double> rate_units(const Topology& topology, const CoordinateBasis& basis);

/// The twist of a body [SI] from a solution of the velocity system; zero for the ground.
Twist body_twist(const VecX& solution, const CoordinateBasis& basis, BodyId body);

/// The equations of equilibrium: for every body except the ground, the actions of its couplings
/// (positive as those of tail on head) and its loads sum to zero. Rows: order · (n - 1) for n
/// bodies. Columns: the actions. The rank is rank A_N.
SparseMatrix action_system(const Topology& topology,
                           const Geometry& geometry,
                           const CoordinateBasis& basis);

/// The right-hand side of the action system: the negative wrenches on the bodies, which `basis`
/// must hold. Wrenches on the ground do not count. Empty, which means zero, if there are no loads.
/// `body_count` includes the ground.
std::vector<double> load_vector(int body_count,
                                const CoordinateBasis& basis,
                                std::span<const BodyWrench> loads);

/// SI per unit of the unknown of an action: 1 for a force, the length unit for a couple.
double action_unit(const Topology& topology, const CoordinateBasis& basis, int action);

/// The units of all actions.
std::vector<double> action_units(const Topology& topology, const CoordinateBasis& basis);

}  // namespace kinestat
