// The equilibrium of a mechanism in a state, forces of inertia and all that acts among its loads.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "mechanism/couplings/coupling_reactions.hpp"
#include "mechanism/gears/coast_flanks.hpp"
#include "statics/friction_solve.hpp"
#include "statics/static_solution.hpp"
#include "studies/motion/motion_solution.hpp"
#include "studies/simulation/rubbing.hpp"

namespace kinestat {

/// The actions of actuators are among the loads, as all of them are known in a simulation: what
/// equilibrium says is what couplings bear. One a thread; all must outlive it.
class StateBalance {
 public:
  StateBalance(const Mechanism& mechanism,
               const MotionNetwork& network,
               std::span<const DrawnCoupling> drawn);

  /// Moves the mechanism there; `off` is by how much its points may be.
  void place(const Configuration& configuration, std::span<const BodyPose> poses, double off);

  const Mechanism& moved() const { return moved_; }

  /// An action about or along a freedom, of tail on head, and its opposite.
  void add_pair(int freedom, double magnitude, std::vector<BodyWrench>& loads) const;

  /// Of a dry friction, its sliding having that sense and speed; `at_rest` with the coefficient of
  /// rest. Without what is viscous. `slips` tells of a virtual link whether its cable does.
  FrictionLaw law_of(std::size_t friction,
                     double sense,
                     double rate,
                     bool at_rest,
                     const std::function<bool(CouplingId)>& slips) const;

  /// On which it acts.
  BodyPair rubbed_bodies(const FrictionLaw& law) const;

  FrictionMagnitudes solve_friction(std::span<const BodyWrench> loads,
                                    std::span<const FrictionLaw> laws,
                                    std::span<const std::vector<BodyWrench>> along);

  /// All actions, with teeth on the flanks that these press; empty what equilibrium does not
  /// determine.
  std::vector<std::optional<double>> solve(std::span<const BodyWrench> loads);

  /// Lets teeth press on the flanks on which these loads press them, friction among them. True if
  /// some press on another one than before, so that friction of bearings differs.
  bool turn_flanks(std::span<const BodyWrench> loads);

  /// The resultants of `coupling_reactions` under these magnitudes of all actions and of each
  /// friction, of tail on head, where `poses` are those of the last place [N].
  std::vector<std::optional<Vec3>> reactions(std::span<const std::optional<double>> magnitudes,
                                             std::span<const std::optional<double>> friction,
                                             std::span<const BodyPose> poses) const;

  /// The actions of teeth that pull on each other under these magnitudes of all actions, which were
  /// solved last.
  std::vector<int> pulling(std::span<const std::optional<double>> magnitudes) const;

 private:
  std::vector<std::optional<double>> solve_on_flanks(std::span<const BodyWrench> loads) const;
  void note_largest(std::span<const BodyWrench> loads);
  ForceOf tooth_forces(std::span<const std::optional<double>> magnitudes) const;
  bool turn_flanks_under(std::span<const std::optional<double>> magnitudes);
  std::vector<std::optional<double>> solve_with_rounding(const CoordinateBasis& basis,
                                                         std::span<const BodyWrench> loads) const;

  const Mechanism& mechanism_;
  const MotionNetwork& network_;
  std::span<const DrawnCoupling> drawn_;
  Mechanism moved_;
  std::vector<Rubbing> sliding_;  // without what is viscous
  std::vector<Rubbing> resting_;
  std::vector<Primary> idle_;  // the actions of actuators, which are loads here
  std::vector<CouplingReaction> reactions_;
  double largest_load_ = 0.0;  // of those that were solved last [N]
  std::vector<int> coast_;     // flanks on which teeth press, as they did last
};

}  // namespace kinestat
