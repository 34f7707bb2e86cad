// The coordinates in which the kinematics and the statics of a mechanism are written.
#pragma once

#include "mechanism/mechanism.hpp"
#include "screw/coordinate_basis.hpp"

namespace kinestat {

/// For the unit motions, by the order asked for (theory: Cazangi 2008, section 3.8.1, the order of
/// the screw system λ). Minimal is the least that holds them all: 2 for the Ravigneaux train.
CoordinateBasis motion_basis(const Geometry& geometry, OrderChoice order);

/// For the unit actions.
CoordinateBasis action_basis(const Geometry& geometry, OrderChoice order);

}  // namespace kinestat
