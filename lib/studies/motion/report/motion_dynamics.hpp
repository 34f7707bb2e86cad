// What a motion with inertia tells as a whole, beside its rows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/types.hpp"
#include "expression/file_units.hpp"
#include "mechanism/label_kind.hpp"

namespace kinestat {

/// The speed of a cycle with a flywheel, while the drive gives its mean torque [rad/s]; places are
/// positions of that [rad].
struct CycleSpeed {
  double greatest = 0.0;
  double greatest_at = 0.0;
  double least = 0.0;
  double least_at = 0.0;
  double fluctuation = 0.0;  ///< greatest less least, over the mean
};

/// A flywheel that keeps the speed of a cycle nearly steady [SI].
struct FlywheelFigures {
  std::string at;            ///< the actuator on whose freedom it turns
  std::string motor;         ///< that which drives the cycle
  bool motor_turns = true;   ///< or it slides
  double fluctuation = 0.0;  ///< that is allowed
  double speed = 0.0;        ///< mean speed of the flywheel
  double mean_action = 0.0;  ///< of the motor, steady with the flywheel
  double energy = 0.0;       ///< greatest less least of what the motor has given too much [J]
  double inertia = 0.0;      ///< that is needed, beside what turns already
  std::optional<CycleSpeed> with_it;  ///< empty where actions hang on speed
};

/// One order: amplitude · cos(order · turn - phase).
struct Harmonic {
  int order = 0;
  double amplitude = 0.0;       ///< [SI]
  std::optional<double> phase;  ///< [rad]; empty of one that is zero
};

/// What is taken apart by the turn of the drive.
struct HarmonicSeries {
  std::string name;  ///< that of a column: motor/action, shaking/force/x
  QuantityKind kind = QuantityKind::dimensionless;
  double mean = 0.0;
  std::vector<Harmonic> orders;
};

/// A counterweight as drawn.
struct Counterweight {
  std::string body;
  Vec3 mass_radius = Vec3::Zero();  ///< mass times place beside the axis [kg·m]
};

/// The shaking force without and with counterweights [N].
struct ShakingForce {
  double rms = 0.0;
  double greatest = 0.0;
  double greatest_at = 0.0;  ///< position of the first drive [rad or m]
};

/// Its components at one time [N].
struct ShakingPoint {
  Vec3 before = Vec3::Zero();
  Vec3 after = Vec3::Zero();
};

struct BalanceFigures {
  std::vector<Counterweight> counterweights;
  ShakingForce before;
  ShakingForce after;
  std::vector<ShakingPoint> path;  ///< along the motion, for pictures
};

/// The steady speed at which a contact, or a cable, loses its force.
struct LimitSpeed {
  std::string coupling;
  std::string action;
  std::optional<double> speed;  ///< of the first drive [rad/s or m/s]; empty: at none
  std::optional<double> at;     ///< where: position of the first drive [rad or m]
};

struct MotionDynamics {
  std::optional<FlywheelFigures> flywheel;
  std::vector<HarmonicSeries> harmonics;
  std::optional<BalanceFigures> balance;
  std::vector<LimitSpeed> limit_speeds;
  bool drive_turns = true;  ///< the first
  bool is_planar = false;
  FileUnits units;

  /// Of positions of the first drive.
  QuantityKind place_kind() const { return position_kind(drive_turns); }

  bool is_empty() const {
    return !flywheel && harmonics.empty() && !balance && limit_speeds.empty();
  }
};

}  // namespace kinestat
