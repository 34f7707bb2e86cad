// The coordinates in which the kinematics and the statics of a mechanism are written.
#pragma once

#include <span>

#include "mechanism/mechanism.hpp"
#include "screw/coordinate_basis.hpp"

namespace kinestat {

/// The basis of the unit motions, of the requested order (Cazangi 2008, 3.8.1, p. 36, the order λ
/// of the screw system). `minimal` is the smallest that holds them all: 2 for the Ravigneaux train.
CoordinateBasis motion_basis(const Geometry& geometry, OrderChoice order);

/// The basis of the unit actions and the loads, of the requested order. `minimal` is the smallest
/// that holds the actions. If this does not hold a load, within kRankZero of the size of the load,
/// it is the planar or the spatial basis, so that a load that nothing resists is not overlooked.
CoordinateBasis action_basis(const Geometry& geometry,
                             OrderChoice order,
                             std::span<const BodyWrench> loads = {});

/// The same, given the basis of the actions without loads.
CoordinateBasis action_basis(CoordinateBasis of_actions,
                             const Geometry& geometry,
                             std::span<const BodyWrench> loads);

}  // namespace kinestat
