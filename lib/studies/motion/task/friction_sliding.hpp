// How frictions slide in the positions of a motion.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "studies/motion/task/motion_position.hpp"

namespace kinestat {

/// How frictions slide beside a row is seen so many steps from it.
inline constexpr double kBesideRow = 0x1p-10;

/// How the frictions of a mechanism slide in one position.
struct FrictionSliding {
  /// Of each the motion against which it works [rad/s or m/s]: the rate of the one freedom of a
  /// bearing, guide or thread; the velocity along the freedoms that slide of a contact, whose turns
  /// have no friction. Zero where the friction has no direction; empty where no motion is known.
  std::vector<Vec3> rates;
  bool stands = false;  ///< a drive of a motion in time rests

  /// Whether this one has a direction.
  bool slides(std::size_t friction) const { return !rates.empty() && !rates[friction].isZero(0.0); }
};

/// The same at a row, or at a place between two rows.
struct FrictionPlace {
  double step = 0.0;
  std::optional<std::size_t> row = {};
  FrictionSliding sliding = {};
};

FrictionSliding sliding_at(const Mechanism& mechanism,
                           const MotionPlan& plan,
                           const MotionPosition& position);

/// The speeds alone, without what decides whether these are rests.
std::vector<Vec3> sliding_speeds(const Mechanism& mechanism, const MotionPosition& position);

/// The same of one coupling with friction, by the rates of all freedoms [rad/s or m/s].
Vec3 sliding_of(const Topology& topology,
                CouplingId coupling,
                std::span<const std::optional<double>> rates);

}  // namespace kinestat
