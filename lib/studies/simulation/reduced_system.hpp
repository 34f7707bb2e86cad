// M q'' + h = Q of a mechanism on which all actions are known, in any state.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "dynamics/curve_loads.hpp"
#include "dynamics/spring_force.hpp"
#include "studies/motion/joint_follower.hpp"
#include "studies/motion/motion_state.hpp"

namespace kinestat {

/// Why a state has no accelerations.
struct SimulationObstacle {
  enum class Kind {
    no_branch,    ///< the closure cannot be followed there
    singular,     ///< the coordinates do not determine the velocities
    no_inertia,   ///< a freedom moves nothing that has mass or inertia
    rotor,        ///< a body of which only the inertia about one axis is known turns about another
    spring,       ///< nothing can be said of a spring
    curve,        ///< nor of what follows a curve
    beyond_stop,  ///< a freedom begins beyond its stop
    no_progress,  ///< stops are struck again and again at one time
    no_step,      ///< the steps of the integration vanish
    too_many_steps  ///< of the integration
  };

  Kind kind = Kind::no_branch;
  std::optional<SpringObstacle> of_spring = {};
  std::optional<CurveObstacle> of_curve = {};
  std::optional<BodyId> body = {};  ///< rotor
};

/// The mechanism in a state.
struct ReducedState {
  MotionState state;                             ///< with all accelerations
  std::vector<std::optional<double>> positions;  ///< of the freedoms
  std::vector<double> held;                      ///< what each held coordinate takes [N·m or N]
  std::vector<double> actions;                   ///< that the case knows, in its order
  double kinetic = 0.0;                          ///< [J]
  double potential = 0.0;                        ///< of weights and springs, as drawn zero [J]
};

/// Coordinates are those of the drives of a network: the free ones first, then those whose
/// acceleration is given. One a thread.
class ReducedSystem {
 public:
  /// The mechanism and the case must outlive it.
  ReducedSystem(const Mechanism& mechanism,
                const Case& which,
                MotionNetwork network,
                std::size_t free_count);
  ReducedSystem(const ReducedSystem&) = delete;
  ReducedSystem& operator=(const ReducedSystem&) = delete;

  const MotionNetwork& network() const { return network_; }

  JointFollower& follower() { return follower_; }

  std::size_t free_count() const { return free_count_; }

  std::size_t held_count() const { return network_.driven_rates.size() - free_count_; }

  /// Of the free coordinates, the held ones being steady, into `accelerations`. False where there
  /// are none: `obstacle`.
  [[nodiscard]] bool accelerate(double time,
                                const Configuration& configuration,
                                std::span<const double> speeds,
                                std::span<double> accelerations);

  const SimulationObstacle& obstacle() const { return obstacle_; }

  /// Of the last state that was accelerated: what actions, loads and held motions give, and what
  /// dampers and friction take [W].
  double supplied() const { return supplied_; }

  double lost() const { return lost_; }

  /// What holds each held coordinate there [N·m or N].
  std::span<const double> held_actions() const { return held_; }

  /// What the rates of a freedom are for unit speeds of all coordinates there.
  VecX direction_of(int freedom) const;

  /// What an impulse about or along a freedom changes of the speeds of the free coordinates, by
  /// unit speed that the freedom changes by; and the inertia that it meets [kg·m² or kg].
  struct Impulse {
    VecX speeds;  ///< of the free coordinates
    VecX held;    ///< impulses that hold the held ones [N·s or N·m·s]
    double inertia = 0.0;
  };

  std::optional<Impulse> impulse_at(int freedom) const;

  /// Everything that is told of the last state that was accelerated.
  ReducedState tell(const Configuration& configuration,
                    std::span<const double> speeds,
                    std::span<const double> accelerations);

 private:
  bool fail(SimulationObstacle::Kind kind) {
    obstacle_ = {.kind = kind};
    return false;
  }

  void add_inertia();
  bool add_forces(double time, const Configuration& configuration);
  void add_wrench(BodyId body, const Wrench& wrench);
  void add_springs(const std::vector<SpringState>& springs, std::span<const double> forces);
  double potential() const;
  std::optional<BodyId> wrong_rotor() const;
  double unit_rate(std::size_t drive, int freedom) const;

  const Mechanism& mechanism_;
  Case which_;
  MotionNetwork network_;
  std::size_t free_count_ = 0;
  JointFollower follower_;
  MotionStates states_;
  bool needs_place_ = false;
  GivenSpeeds speeds_;
  MotionState state_;
  std::vector<MotionState> units_;
  LoadPlace place_;
  std::vector<SpringState> springs_;
  std::vector<double> actions_;
  MatX inertia_;
  VecX bias_;
  VecX forces_;
  std::vector<double> held_;
  double supplied_ = 0.0;
  double lost_ = 0.0;
  SimulationObstacle obstacle_;
};

}  // namespace kinestat
