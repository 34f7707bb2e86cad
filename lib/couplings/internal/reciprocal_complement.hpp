// The screws that are reciprocal to given ones.
#pragma once

#include "couplings/coupling_geometry.hpp"

namespace kinestat {

/// The unit actions that do no work on any of the freedoms: as many as the order of the space minus
/// their rank. They are rows of a reduced echelon form in the order Fx Fy Fz Tx Ty Tz, moments
/// about `at`, each scaled to a unit force (a unit couple where there is no force) and named by its
/// leading coordinate: Rx, Ty. So the complement of a rotation is what a revolute bears.
template <class Scalar>
std::vector<NamedWrenchOf<Scalar>> reciprocal_wrenches(
    const std::vector<NamedTwistOf<Scalar>>& freedoms, bool is_planar, const Vec3In<Scalar>& at);

/// The unit motions on which none of the constraints does work, likewise in the order wx wy wz vx
/// vy vz, velocities of the point at `at`.
template <class Scalar>
std::vector<NamedTwistOf<Scalar>> reciprocal_twists(
    const std::vector<NamedWrenchOf<Scalar>>& constraints,
    bool is_planar,
    const Vec3In<Scalar>& at);

}  // namespace kinestat
