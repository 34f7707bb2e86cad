#include "power/power_flow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "power/efficiency.hpp"
#include "power/internal/bounded_magnitude.hpp"

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
    if (!friction.between && static_cast<std::size_t>(friction.coupling.value) == coupling) {
      sum += power(friction.wrench, motion.couplings[coupling]);
    }
  }
  return sum;
}

// What the power of a wrench on a motion may round by: both are written about a common origin, from
// which the terms may be far larger than their sum. A dozen roundings make the terms and their sum.
double rounding_of(const Wrench& wrench, const Twist& twist) {
  const double largest_terms = wrench.moment.cwiseAbs().dot(twist.angular.cwiseAbs()) +
                               wrench.force.cwiseAbs().dot(twist.linear.cwiseAbs());
  return 6.0 * std::numeric_limits<double>::epsilon() * largest_terms;
}

std::optional<double> bound_of_powers(const Mechanism& mechanism,
                                      const KinematicSolution& motion,
                                      const StaticSolution& action,
                                      double largest) {
  if (!has_bounds(motion.answer) || !has_bounds(action.answer) || largest == 0.0) {
    return std::nullopt;
  }
  BoundedNumber sum;  // its bound is that of each part, too
  for (const ActuatorTopology& actuator : mechanism.topology.actuators) {
    sum = sum + bounded_action(action, actuator.action) * bounded_rate(motion, actuator.freedom);
  }
  return std::min(sum.bound / largest, 1.0);
}

// Of the bodies that a friction loads, the head as seen from the tail.
Twist relative_motion(const FrictionAction& friction, const KinematicSolution& motion) {
  if (!friction.between) {
    return motion.couplings[static_cast<std::size_t>(friction.coupling.value)];
  }
  return motion.bodies[static_cast<std::size_t>(friction.between->head.value)] -
         motion.bodies[static_cast<std::size_t>(friction.between->tail.value)];
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
  double rounding = 0.0;
  for (std::size_t e = 0; e < mechanism.topology.couplings.size(); ++e) {
    const auto head = static_cast<std::size_t>(mechanism.topology.couplings[e].head.value);
    const bool is_real = !is_by_convention(action, mechanism.topology.couplings[e]);
    const std::optional<Wrench> wrench = is_real ? action.wrenches[e] : std::nullopt;
    flow.into_head.push_back(wrench ? std::optional(power(*wrench, motion.bodies[head]))
                                    : std::nullopt);
    flow.supplied.push_back(wrench ? power(*wrench, motion.couplings[e])
                                   : power_of_actuators_and_friction(mechanism, e, motion, action));
    sum += flow.supplied.back();
    rounding += wrench ? rounding_of(*wrench, motion.couplings[e]) : 0.0;
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
    flow.friction.push_back(power(friction.wrench, relative_motion(friction, motion)));
    sum += friction.between ? flow.friction.back() : 0.0;
  }
  flow.input = input_power(which, flow);
  if (!flow.friction.empty()) {
    Efficiency found = find_efficiency(
        which, {.actuators = flow.actuators, .loads = flow.loads, .largest = largest});
    flow.efficiency = found.value;
    flow.no_efficiency = std::move(found.reason);
    flow.is_self_locking = found.is_self_locking;
  }
  flow.largest = largest;
  flow.balance_residual = largest == 0.0 ? 0.0 : std::abs(sum) / largest;
  flow.is_balanced = std::abs(sum) <= std::max(kPowerBalance * largest, rounding);
  flow.error_bound = bound_of_powers(mechanism, motion, action, largest);
  return flow;
}

}  // namespace kinestat
