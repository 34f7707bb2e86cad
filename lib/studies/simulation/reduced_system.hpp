// M q'' + h = Q of a mechanism on which all actions are known, in any state.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "dynamics/curve_loads.hpp"
#include "dynamics/spring_force.hpp"
#include "studies/motion/joint_follower.hpp"
#include "studies/motion/motion_state.hpp"
#include "studies/simulation/internal/acting_friction.hpp"
#include "studies/simulation/reduced_state.hpp"
#include "studies/simulation/state_balance.hpp"

namespace kinestat {

/// Coordinates are the drives of a network, free ones before those that are held. One a thread.
class ReducedSystem {
 public:
  /// All must outlive it. `balance` may be null where nothing rubs and no actions are asked for.
  ReducedSystem(const Mechanism& mechanism,
                const Case& which,
                MotionNetwork network,
                std::size_t free_count,
                StateBalance* balance);
  ReducedSystem(const ReducedSystem&) = delete;
  ReducedSystem& operator=(const ReducedSystem&) = delete;

  const MotionNetwork& network() const { return network_; }

  JointFollower& follower() { return follower_; }

  std::size_t free_count() const { return free_count_; }

  std::size_t held_count() const { return network_.driven_rates.size() - free_count_; }

  /// Of each of `find_rubbing`; none act before. `is_open`: shares of what sticks are not known.
  void set_friction(std::vector<FrictionSense> senses, bool is_open);

  /// Of the free coordinates, the held ones steady. False where there are none: `obstacle`.
  [[nodiscard]] bool accelerate(double time,
                                const Configuration& configuration,
                                std::span<const double> speeds,
                                std::span<double> accelerations);

  const SimulationObstacle& obstacle() const { return obstacle_; }

  /// Of the last state that was accelerated, and what holds each held coordinate [N·m or N].
  const StatePowers& powers() const { return powers_; }

  std::span<const double> held_actions() const { return held_; }

  /// What a spring would pull if it acted both ways [N]; without its damping; and without `force`.
  double uncut_tension(std::size_t spring) const;
  double uncut_tension_at_rest(std::size_t spring) const;
  double uncut_elastic_tension(std::size_t spring) const;

  /// What the rates of a freedom are for unit speeds of all coordinates there.
  VecX direction_of(int freedom) const;
  VecX direction_of(std::span<const SlidingTerm> slides) const;

  /// What an impulse about or along a freedom does by unit speed that this changes by.
  struct Impulse {
    VecX speeds;           ///< of the free coordinates
    VecX held;             ///< impulses that hold the held ones [N·s or N·m·s]
    double inertia = 0.0;  ///< that it meets [kg·m² or kg]
  };

  std::optional<Impulse> impulse_at(int freedom) const;

  /// Of all actions where it changes the freedom by so much [N·s or N·m·s].
  std::vector<std::optional<double>> borne_in(const Impulse& impulse, int freedom, double change);

  std::optional<double> acceleration_of(int freedom,
                                        const Configuration& configuration,
                                        std::span<const double> speeds,
                                        std::span<const double> accelerations);

  /// The rates of all freedoms.
  std::vector<std::optional<double>> rates(const Configuration& configuration,
                                           std::span<const double> speeds);

  /// Everything that is told of the last state that was accelerated.
  ReducedState tell(const Configuration& configuration,
                    std::span<const double> speeds,
                    std::span<const double> accelerations,
                    bool with_actions);

  /// Of a singular one, or nearly: positions, potential, the speeds that are determined.
  std::optional<ReducedState> tell_singular(const Configuration& configuration,
                                            std::span<const double> speeds);

 private:
  bool fail(SimulationObstacle::Kind kind);
  void add_inertia();
  void set_speeds(std::span<const double> speeds, std::span<const double> accelerations);
  bool add_friction(VecX& accelerations);
  bool slides(CouplingId id) const;
  std::optional<ActingFriction> acting_friction(std::size_t i);
  std::optional<std::vector<ActingFriction>> acting_frictions();
  std::optional<VecX> friction_magnitudes(const std::vector<ActingFriction>& acting,
                                          std::span<const BodyWrench> loads);
  double held_by_inertia(const VecX& accelerations, std::size_t k) const;
  std::vector<double> held_with(const VecX& accelerations) const;
  std::vector<BodyWrench> inertial(const VecX& accelerations) const;
  void add_held(std::span<const double> held, std::vector<BodyWrench>& loads) const;
  void find_borne(const MotionState& state, ReducedState& told);
  bool add_forces(double time, const Configuration& configuration);
  void add_wrench(BodyId body, const Wrench& wrench);
  void add_springs(const std::vector<SpringState>& springs, std::span<const double> forces);
  double potential(const MotionState& state) const;
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
  StateBalance* balance_ = nullptr;
  std::vector<Rubbing> frictions_;
  std::vector<FrictionSense> senses_;
  bool is_open_ = false;
  std::vector<BodyWrench> loads_;                // but for inertia, dry friction and what is held
  std::vector<BodyWrench> rubbing_;              // dry friction
  std::vector<std::optional<double>> friction_;  // of each
  std::vector<Wrench> inertial_;                 // of the bodies, the coordinates being steady
  std::vector<std::vector<Wrench>> carried_;     // momentum for a unit speed of each coordinate
  LoadState place_;
  std::vector<SpringState> springs_;
  std::vector<double> spring_forces_;
  std::vector<double> actions_;
  std::vector<double> load_powers_;
  MatX inertia_;
  VecX bias_;
  VecX forces_;
  VecX sizes_;  // of what adds up in each equation
  std::vector<double> held_;
  StatePowers powers_;
  SimulationObstacle obstacle_;
};

}  // namespace kinestat
