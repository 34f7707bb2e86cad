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

/// A value and where it is: position of the first drive [rad or m].
struct PlacedValue {
  double value = 0.0;
  double at = 0.0;
};

/// An actuator at one time.
struct ActuatorPoint {
  double time = 0.0;    ///< [s]
  double drive = 0.0;   ///< position of the first drive [rad or m]
  double speed = 0.0;   ///< of its own freedom [rad/s or m/s]
  double action = 0.0;  ///< [N·m or N]
};

/// What an actuator has to do in the whole motion.
struct ActuatorFigures {
  std::string name;
  bool turns = true;                ///< or it slides
  PlacedValue peak;                 ///< action of the largest size
  double mean = 0.0;                ///< of the action, in time
  double rms = 0.0;                 ///< likewise
  PlacedValue peak_speed;           ///< of the largest size
  PlacedValue peak_power;           ///< of the largest size; positive where it drives [W]
  double mean_power = 0.0;          ///< [W]
  double energy_in = 0.0;           ///< that it gives while it drives [J]
  double energy_out = 0.0;          ///< that it takes while it brakes [J]
  std::vector<ActuatorPoint> path;  ///< along the motion, for pictures
};

/// Where the energy of the whole motion comes from and goes [J].
struct EnergyFigures {
  double actuators = 0.0;  ///< of all actuators
  double loads = 0.0;      ///< of loads, weights and springs
  double lost = 0.0;       ///< in friction and meshes
  bool has_lossy_meshes = false;
  double kinetic_change = 0.0;  ///< end less begin
  double greatest_kinetic = 0.0;
  std::optional<double> audit;       ///< by how much these differ, as share of the greatest kinetic
                                     ///< energy; empty where nothing moves
  std::optional<double> efficiency;  ///< of the whole: find_efficiency by energies
  std::string no_efficiency;         ///< why there is none, of a case that names both ends
};

struct MotionDynamics {
  std::vector<ActuatorFigures> actuators;
  std::optional<EnergyFigures> energy;  ///< beside these
  double duration = 0.0;                ///< [s]
  bool is_steady = true;                ///< one drive that runs at one speed
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
    return actuators.empty() && !flywheel && harmonics.empty() && !balance && limit_speeds.empty();
  }
};

}  // namespace kinestat
