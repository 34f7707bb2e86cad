// Velocities and accelerations in a configuration.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "studies/motion/configuration.hpp"
#include "studies/motion/state_bounds.hpp"

namespace kinestat {

/// How fast a drive runs.
struct DriveSpeed {
  double speed = 0.0;               ///< [rad/s or m/s]
  double acceleration = 0.0;        ///< [rad/s² or m/s²]
  double speed_bound = 0.0;         ///< how far off they may be
  double acceleration_bound = 0.0;  ///< likewise
};

/// The constant rate of a freedom that the drives leave open.
struct PassiveSpeed {
  int freedom = 0;     ///< index into Topology::freedoms
  double speed = 0.0;  ///< [rad/s or m/s]
};

/// What is known of the velocities.
struct GivenSpeeds {
  std::vector<DriveSpeed> drives;     ///< parallel to the driven freedoms of the network
  std::vector<PassiveSpeed> passive;  ///< those of freedoms that are not open count for nothing
};

enum class StateDetail { velocity, acceleration };

/// Twists are written about the origin of the geometry. Lists of bodies and freedoms are parallel
/// to the topology.
struct MotionState {
  bool is_singular = false;  ///< the drives do not determine the velocities, or hardly
                             ///< (kFlatVelocity): nothing but poses
  std::vector<BodyPose> poses;
  std::vector<Twist> twists;
  std::vector<Twist> twist_rates;                 ///< time derivatives; empty unless asked for, and
                                                  ///< nearer a singular position than
                                                  ///< kFlatAcceleration
  std::vector<std::optional<double>> rates;       ///< of the freedoms [rad/s or m/s]; empty of
                                                  ///< contacts and cables
  std::vector<std::optional<double>> rate_rates;  ///< their derivatives [rad/s² or m/s²]; empty
                                                  ///< likewise
  StateBounds bounds;  ///< where asked for; then zero is what they do not tell from it, except
                       ///< where they are more than rounding (is_reported)
};

/// The states of a mechanism in many configurations, its equations prepared once. Where passive
/// freedoms stay open it takes the least motion in the coordinates. The rates of a ball are about
/// world axes, and one that is given stays constant there. One a thread.
class MotionStates {
 public:
  MotionStates(const MotionNetwork& network, const Mechanism& mechanism);
  ~MotionStates();
  MotionStates(const MotionStates&) = delete;
  MotionStates& operator=(const MotionStates&) = delete;

  /// Asked for the configuration of the last call, it solves no equations of closure again.
  [[nodiscard]] MotionState solve(const Configuration& configuration,
                                  const GivenSpeeds& speeds,
                                  StateDetail detail);

  /// The same with bounds of its errors, and set to zero by these: for what is reported.
  [[nodiscard]] MotionState solve_bounded(const Configuration& configuration,
                                          const GivenSpeeds& speeds,
                                          StateDetail detail);

  /// As those of configuration.hpp.
  [[nodiscard]] std::vector<std::optional<double>> freedom_positions(
      const Configuration& configuration);

 private:
  struct Solver;

  std::size_t drive_count_ = 0;
  std::unique_ptr<Solver> solver_;
};

/// In the world frame, with the bound of each component: 0 where the state has none.
struct BoundedRate {
  Vec3 value = Vec3::Zero();
  double bound = 0.0;
};

/// Of the point of a body that was drawn at `drawn`. Accelerations are zero where the state has
/// none; where it has bounds, components are set to zero by them. The position in the frame
/// of the mechanism or, given `origin`, in the world.
Vec3 point_position(const MotionState& state,
                    BodyId body,
                    const Vec3& drawn,
                    const LocalOrigin& origin = {});
BoundedRate point_velocity(const MotionState& state, BodyId body, const Vec3& drawn);
BoundedRate point_acceleration(const MotionState& state, BodyId body, const Vec3& drawn);

}  // namespace kinestat
