// What a transmission can do with all its shift elements open.
#pragma once

#include <algorithm>
#include <vector>

#include "math/numbers/bounded_number.hpp"
#include "mechanism/mechanism.hpp"
#include "mechanism/shift_plan.hpp"
#include "screw/coordinate_basis.hpp"

namespace kinestat {

/// A rate in each motion of the open train.
using RateRow = std::vector<BoundedNumber>;

/// The motions of the open train; a row is the rate of an actuator [rad/s or m/s] in each, and of
/// `bodies` a coordinate of a twist, `order` rows a body but the ground, in the units of the basis.
/// Engaging elements picks some of these motions: one elimination serves all states. A rate may be
/// off by the rounding of the largest rate of its motion; what is less than that is zero.
struct ShiftNetwork {
  int motions = 0;  ///< F_N: how many must be known
  std::vector<RateRow> inputs;
  std::vector<RateRow> outputs;
  std::vector<RateRow> elements;
  std::vector<RateRow> others;  ///< actuators that only hang on
  std::vector<RateRow> bodies;
  int order = 0;  ///< rows of `bodies` a body

  int net_freedom() const { return motions; }

  /// How many elements a gear engages: what the inputs leave of the mobility; none if they leave
  /// nothing.
  int needed() const { return std::max(0, motions - static_cast<int>(inputs.size())); }

  /// How many more it may engage: so many inputs then follow from the others.
  int following(const ShiftPlan& plan) const {
    return plan.is_hybrid() ? std::min(motions, static_cast<int>(inputs.size())) - 1 : 0;
  }
};

/// From one elimination of the velocity system without primaries (Davies; Cazangi 2008, section
/// 3.8.1). `basis` must hold all unit motions.
ShiftNetwork make_shift_network(const Mechanism& mechanism,
                                const CoordinateBasis& basis,
                                const ShiftPlan& plan);

}  // namespace kinestat
