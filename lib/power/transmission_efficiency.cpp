#include "power/transmission_efficiency.hpp"

#include <utility>

#include "power/absolute_efficiency.hpp"
#include "statics/friction.hpp"

namespace kinestat {

namespace {

// The same motion, driven from the other end.
Case reversed(Case which) {
  for (Primary& primary : which.actions) {
    primary.value = -primary.value;
  }
  for (Load& load : which.loads) {
    load.acts.wrench = -1.0 * load.acts.wrench;
  }
  std::swap(which.inputs, which.outputs);
  return which;
}

class LossyCase {
 public:
  LossyCase(const Mechanism& mechanism,
            const CoordinateBasis& basis,
            const KinematicSolution& motion,
            std::span<const FrictionLaw> laws)
      : mechanism_(mechanism), basis_(basis), motion_(motion), laws_(laws) {}

  StaticSolution solve(const Case& which) const {
    return solve_with_friction(mechanism_, basis_, which.actions, wrenches_of(which.loads), laws_);
  }

  Efficiency efficiency_of(const Case& which, const StaticSolution& action) const {
    if (action.status == SolveStatus::locked) {
      return {.value = std::nullopt,
              .reason = "losses take more than the inputs give",
              .is_self_locking = true};
    }
    if (!determines_power(mechanism_, action)) {
      return {.value = std::nullopt, .reason = "the actions of actuators are open"};
    }
    const PowerFlow flow = find_power(mechanism_, which, motion_, action);
    return find_efficiency(which, flow.actuators, flow.loads);
  }

 private:
  const Mechanism& mechanism_;
  const CoordinateBasis& basis_;
  const KinematicSolution& motion_;
  std::span<const FrictionLaw> laws_;
};

// The mesh losses that are not idle.
void add_losses(const StaticSolution& action,
                const KinematicSolution& motion,
                TransmissionEfficiency& result) {
  for (const FrictionAction& one : action.friction) {
    if (one.between && one.magnitude > 0.0) {
      const Twist turning = motion.bodies[static_cast<std::size_t>(one.between->head.value)] -
                            motion.bodies[static_cast<std::size_t>(one.between->tail.value)];
      result.losses.push_back(one);
      result.loss_powers.push_back(power(one.wrench, turning));
    }
  }
}

Efficiency find_absolute(const Mechanism& mechanism,
                         const Case& which,
                         const PowerFlow& power,
                         const PowerGraph& graph) {
  Efficiency result = find_efficiency(which, power.actuators, power.loads);
  if (result.value) {
    result.value = find_absolute_efficiency(mechanism, graph);
    result.reason = result.value ? "" : "the powers of some bodies are open";
  }
  return result;
}

}  // namespace

TransmissionEfficiency find_transmission_efficiency(const Mechanism& mechanism,
                                                    const CoordinateBasis& basis,
                                                    const Case& which,
                                                    const KinematicSolution& motion,
                                                    std::span<const FrictionLaw> laws,
                                                    const PowerFlow& power,
                                                    const PowerGraph& graph) {
  TransmissionEfficiency result;
  const LossyCase lossy(mechanism, basis, motion, laws);
  const StaticSolution forward = lossy.solve(which);
  result.carrier = lossy.efficiency_of(which, forward);
  result.actions = forward.magnitudes;
  add_losses(forward, motion, result);
  const Case back = reversed(which);
  result.carrier_backward = lossy.efficiency_of(back, lossy.solve(back));
  result.absolute = find_absolute(mechanism, which, power, graph);
  return result;
}

}  // namespace kinestat
