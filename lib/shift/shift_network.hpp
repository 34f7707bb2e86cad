// What a transmission can do with all its shift elements open.
#pragma once

#include <algorithm>

#include "mechanism/mechanism.hpp"
#include "mechanism/shift_plan.hpp"
#include "screw/coordinate_basis.hpp"

namespace kinestat {

/// The motions of the open train, one column each; a row is the rate of an actuator [rad/s or m/s],
/// and of `bodies` a coordinate of a twist, `order` rows a body but the ground, in the units of the
/// basis. Engaging elements picks some of these motions: one elimination serves all states.
struct ShiftNetwork {
  MatX inputs;
  MatX outputs;
  MatX elements;
  MatX others;  ///< actuators that only hang on
  MatX bodies;
  int order = 0;  ///< rows of `bodies` a body

  /// F_N: how many motions must be known.
  int net_freedom() const { return static_cast<int>(elements.cols()); }

  /// How many elements a gear engages: what the inputs leave of the mobility; none if they leave
  /// nothing.
  int needed() const { return std::max(0, net_freedom() - static_cast<int>(inputs.rows())); }
};

/// From one elimination of the velocity system without primaries (Davies; Cazangi 2008, section
/// 3.8.1). `basis` must hold all unit motions.
ShiftNetwork make_shift_network(const Mechanism& mechanism,
                                const CoordinateBasis& basis,
                                const ShiftPlan& plan);

}  // namespace kinestat
