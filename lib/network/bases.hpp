// The coordinates in which the kinematics and the statics of a mechanism are written.
#pragma once

#include <span>

#include "mechanism/mechanism.hpp"
#include "screw/coordinate_basis.hpp"

namespace kinestat {

/// For the unit motions, by the order asked for (Cazangi 2008, 3.8.1, p. 36, the order of the
/// screw system λ). Minimal is the least that holds them all: 2 for the Ravigneaux train.
CoordinateBasis motion_basis(const Geometry& geometry, OrderChoice order);

/// For the unit actions and the loads. Minimal is the least that holds the actions, unless a load
/// leaves it by more than kRankZero of its size: then the planar or the spatial one, so that what
/// nothing resists cannot be overlooked.
CoordinateBasis action_basis(const Geometry& geometry,
                             OrderChoice order,
                             std::span<const BodyWrench> loads = {});

/// The same from the basis of the actions alone.
CoordinateBasis action_basis(CoordinateBasis of_actions,
                             const Geometry& geometry,
                             std::span<const BodyWrench> loads);

}  // namespace kinestat
