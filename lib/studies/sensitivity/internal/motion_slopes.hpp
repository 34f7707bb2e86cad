// The velocities and accelerations of a case with their derivatives towards the parameters.
#pragma once

#include <optional>
#include <vector>

#include "studies/sensitivity/dual_case.hpp"

namespace kinestat {

/// Duals by the parameters alone, NaN where velocities have no derivative; lists are parallel to
/// the topology. Empty twists: the case has no motion.
struct MotionSlopes {
  std::vector<Dual> rates;
  std::vector<TwistOf<Dual>> twists;       ///< of bodies, about the origin of the geometry
  std::vector<TwistOf<Dual>> twist_rates;  ///< their time derivatives; empty unless asked for
};

/// The velocities.
MotionSlopes velocity_slopes(const DualCase& values);

/// The same with accelerations. Of a coupling in series with the body before each of its freedoms
/// the screws move with it, those of teeth with their carrier: with V of that body, the twist of
/// the coupling changes by Σ (φ' $ + φ V x $), and the φ' close the circuits (Davies' equations
/// once more). The coupling for which no such law is known is named.
struct AccelerationSlopes {
  MotionSlopes motion;
  std::optional<CouplingId> without_law;
};

AccelerationSlopes acceleration_slopes(const DualCase& values);

}  // namespace kinestat
