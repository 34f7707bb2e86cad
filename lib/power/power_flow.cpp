#include "power/power_flow.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "core/tolerance.hpp"

namespace kinestat {

namespace {

double input_power(const Case& which, const PowerFlow& flow) {
  double sum = 0.0;
  if (!which.inputs.empty()) {
    for (const int i : which.inputs) {
      sum += flow.actuators[static_cast<std::size_t>(i)];
    }
    return sum;
  }
  for (const auto* powers : {&flow.actuators, &flow.loads}) {
    for (const double power : *powers) {
      sum += std::max(power, 0.0);
    }
  }
  return sum;
}

double sum_of(const std::vector<int>& actuators, const PowerFlow& flow) {
  double sum = 0.0;
  for (const int i : actuators) {
    sum += flow.actuators[static_cast<std::size_t>(i)];
  }
  return sum;
}

// Whether all power comes from the inputs and goes to the outputs and into friction.
bool is_between_inputs_and_outputs(const Case& which, const PowerFlow& flow) {
  double largest = 0.0;
  double beside = 0.0;
  for (std::size_t i = 0; i < flow.actuators.size(); ++i) {
    const int actuator = static_cast<int>(i);
    const bool is_named = std::ranges::find(which.inputs, actuator) != which.inputs.end() ||
                          std::ranges::find(which.outputs, actuator) != which.outputs.end();
    double& size = is_named ? largest : beside;
    size = std::max(size, std::abs(flow.actuators[i]));
  }
  for (const double load : flow.loads) {
    beside = std::max(beside, std::abs(load));
  }
  return beside <= kPowerBalance * largest;
}

// What friction leaves of the power, and whether it leaves any.
void find_efficiency(const Case& which, PowerFlow& flow) {
  if (flow.friction.empty() || which.inputs.empty() || which.outputs.empty()) {
    return;
  }
  if (!is_between_inputs_and_outputs(which, flow)) {
    flow.no_efficiency = "loads or other actuators exchange power too";
    return;
  }
  const double in = sum_of(which.inputs, flow);
  const double out = sum_of(which.outputs, flow);
  flow.is_self_locking = in > 0.0 && out > 0.0;
  if (in > 0.0 && out <= 0.0) {
    flow.efficiency = -out / in;
  } else {
    flow.no_efficiency = flow.is_self_locking ? "friction takes more than the inputs give"
                                              : "the inputs give no power";
  }
}

// What a coupling supplies whose passive constraints are not all known: these do no work.
double power_of_actuators_and_friction(const Mechanism& mechanism,
                                       std::size_t coupling,
                                       const KinematicSolution& motion,
                                       const StaticSolution& action) {
  double sum = 0.0;
  for (const ActuatorTopology& actuator : mechanism.topology.actuators) {
    const auto f = static_cast<std::size_t>(actuator.freedom);
    if (static_cast<std::size_t>(mechanism.topology.freedoms[f].coupling.value) == coupling) {
      sum += *action.magnitudes[static_cast<std::size_t>(actuator.action)] * motion.rates[f];
    }
  }
  for (const FrictionAction& friction : action.friction) {
    if (static_cast<std::size_t>(friction.coupling.value) == coupling) {
      sum += power(friction.wrench, motion.couplings[coupling]);
    }
  }
  return sum;
}

}  // namespace

bool determines_power(const Mechanism& mechanism, const StaticSolution& action) {
  return !action.magnitudes.empty() && action.open_friction.empty() &&
         std::ranges::all_of(mechanism.topology.actuators, [&](const ActuatorTopology& actuator) {
           return action.magnitudes[static_cast<std::size_t>(actuator.action)].has_value() &&
                  !is_by_convention(action, actuator.action);
         });
}

PowerFlow find_power(const Mechanism& mechanism,
                     const Case& which,
                     const KinematicSolution& motion,
                     const StaticSolution& action) {
  KINESTAT_EXPECTS(motion.status == SolveStatus::solved && determines_power(mechanism, action));
  PowerFlow flow;
  double sum = 0.0;
  double largest = 0.0;
  for (std::size_t e = 0; e < mechanism.topology.couplings.size(); ++e) {
    const auto head = static_cast<std::size_t>(mechanism.topology.couplings[e].head.value);
    const bool is_real = !is_by_convention(action, mechanism.topology.couplings[e]);
    const std::optional<Wrench> wrench = is_real ? action.wrenches[e] : std::nullopt;
    flow.into_head.push_back(wrench ? std::optional(power(*wrench, motion.bodies[head]))
                                    : std::nullopt);
    flow.supplied.push_back(wrench ? power(*wrench, motion.couplings[e])
                                   : power_of_actuators_and_friction(mechanism, e, motion, action));
    sum += flow.supplied.back();
    largest = std::max(
        {largest, std::abs(flow.into_head.back().value_or(0.0)), std::abs(flow.supplied.back())});
  }
  for (const Load& load : which.loads) {
    const auto body = static_cast<std::size_t>(load.acts.body.value);
    flow.loads.push_back(power(load.acts.wrench, motion.bodies[body]));
    sum += flow.loads.back();
    largest = std::max(largest, std::abs(flow.loads.back()));
  }
  for (const ActuatorTopology& actuator : mechanism.topology.actuators) {
    flow.actuators.push_back(*action.magnitudes[static_cast<std::size_t>(actuator.action)] *
                             motion.rates[static_cast<std::size_t>(actuator.freedom)]);
  }
  for (const FrictionAction& friction : action.friction) {
    const auto e = static_cast<std::size_t>(friction.coupling.value);
    flow.friction.push_back(power(friction.wrench, motion.couplings[e]));
  }
  flow.input = input_power(which, flow);
  find_efficiency(which, flow);
  flow.balance_residual = largest == 0.0 ? 0.0 : std::abs(sum) / largest;
  flow.is_balanced = flow.balance_residual <= kPowerBalance;
  return flow;
}

}  // namespace kinestat
