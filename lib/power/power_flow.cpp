#include "power/power_flow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "math/numbers/zero_within_bound.hpp"
#include "mechanism/position_error.hpp"
#include "power/efficiency.hpp"
#include "power/internal/bounded_magnitude.hpp"

namespace kinestat {

namespace {

double input_power(const Case& which, const PowerFlow& flow) {
  if (which.inputs.size() == 1 && which.input_loads.empty()) {
    return flow.actuators[static_cast<std::size_t>(which.inputs.front())];
  }
  if (!which.inputs.empty() || !which.input_loads.empty()) {
    BoundedNumber total;
    for (const int i : which.inputs) {
      total = total + rounded_as_typed({.value = flow.actuators[static_cast<std::size_t>(i)]});
    }
    for (const std::size_t i : which.input_loads) {
      total = total + rounded_as_typed({.value = flow.loads[i]});
    }
    return total.zeroed();
  }
  double sum = 0.0;
  for (const auto* powers : {&flow.actuators, &flow.loads}) {
    for (const double power : *powers) {
      sum += std::max(power, 0.0);
    }
  }
  return sum;
}

// What a coupling supplies whose passive constraints are not all known: these do no work.
BoundedNumber power_of_actuators_and_friction(const Mechanism& mechanism,
                                              std::size_t coupling,
                                              const KinematicSolution& motion,
                                              const StaticSolution& action) {
  const BoundedTwist twist =
      bounded_coupling(mechanism, motion, CouplingId{static_cast<int>(coupling)});
  BoundedNumber sum;
  for (const ActuatorTopology& actuator : mechanism.topology.actuators) {
    const auto f = static_cast<std::size_t>(actuator.freedom);
    if (static_cast<std::size_t>(mechanism.topology.freedoms[f].coupling.value) == coupling) {
      sum = sum + bounded_action(action, actuator.action) * bounded_rate(motion, actuator.freedom);
    }
  }
  for (const FrictionAction& friction : action.friction) {
    if (!friction.between && static_cast<std::size_t>(friction.coupling.value) == coupling) {
      sum = sum + power(written(friction.wrench), twist);
    }
  }
  return sum;
}

// What the power of a wrench on a motion may round by: both are written about a common origin, from
// which the terms may be far larger than their sum; `terms` are those of the wrench. A dozen
// roundings make them and their sum.
double rounding_of(const Vec6& terms, const Twist& twist) {
  const double largest_terms =
      terms.head<3>().dot(twist.angular.cwiseAbs()) + terms.tail<3>().dot(twist.linear.cwiseAbs());
  return 6.0 * std::numeric_limits<double>::epsilon() * largest_terms;
}

// Places were rounded when they were read.
Vec6 terms_of(const Wrench& wrench, const Vec3& point) {
  const Vec3 p = point.cwiseAbs();
  const Vec3 f = wrench.force.cwiseAbs();
  Vec6 terms = wrench.coordinates().cwiseAbs();
  terms[0] += p.y() * f.z() + p.z() * f.y();
  terms[1] += p.z() * f.x() + p.x() * f.z();
  terms[2] += p.x() * f.y() + p.y() * f.x();
  return terms;
}

// What a power may be off by where the bodies of a moved position are: lines of action are shifted,
// and the points on which they act.
double misplaced_power(const Mechanism& mechanism, const Wrench& wrench, const Twist& twist) {
  const double share = position_error(mechanism);
  if (share == 0.0) {
    return 0.0;
  }
  const double terms = wrench.coordinates().cwiseAbs().dot(twist.coordinates().cwiseAbs());
  return share * (terms + mechanism.geometry.length * wrench.force.norm() * twist.angular.norm());
}

// What a coupling or load may put into rates and actions of a moved position that are zero because
// its bodies may be off: equations are off by the sum of their terms, whatever their directions.
double unreported_power(const Mechanism& mechanism, const Wrench& wrench, const Twist& twist) {
  const double length = mechanism.geometry.length;
  return position_error(mechanism) * (length * wrench.force.norm() + wrench.moment.norm()) *
         (twist.linear.norm() / length + twist.angular.norm());
}

// What the place of a load was rounded by: a coordinate as 50*sqrt(2) - 100*sin(45 deg) is off by a
// share of what it is made of, not of itself.
double misread_power(const Load& load, const Twist& twist) {
  const double apart =
      2.0 * std::numeric_limits<double>::epsilon() * load.point.value_or(Vec3::Zero()).norm();
  return apart * load.acts.wrench.force.norm() * twist.angular.norm();
}

// With rounding, and where the bodies may be off in a moved position.
BoundedNumber load_power(const Mechanism& mechanism,
                         const Load& load,
                         const KinematicSolution& motion) {
  const BodyWrench& acts = load.acts;
  BoundedNumber found = power(written(acts.wrench), bounded_body(motion, acts.body));
  const Twist& twist = motion.bodies[static_cast<std::size_t>(acts.body.value)];
  found.bound += misplaced_power(mechanism, acts.wrench, twist) + misread_power(load, twist);
  return found;
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
BoundedTwist relative_motion(const Mechanism& mechanism,
                             const FrictionAction& friction,
                             const KinematicSolution& motion) {
  if (!friction.between) {
    return bounded_coupling(mechanism, motion, friction.coupling);
  }
  return bounded_body(motion, friction.between->head) -
         bounded_body(motion, friction.between->tail);
}

// A converter may take power from both sides, but it keeps nothing from turning.
bool is_taken_by_converters(const Mechanism& mechanism,
                            const StaticSolution& action,
                            const PowerFlow& flow) {
  double taken = 0.0;
  for (std::size_t i = 0; i < action.friction.size(); ++i) {
    const CouplingTopology& coupling = mechanism.topology.coupling(action.friction[i].coupling);
    taken -= coupling.type == CouplingType::torque_converter ? flow.friction[i] : 0.0;
  }
  return taken > flow.input;
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
  BoundedNumber sum;  // of all that its bounds tell, and of what they do not tell from zero
  double largest = 0.0;
  double rounding = 0.0;
  for (std::size_t e = 0; e < mechanism.topology.couplings.size(); ++e) {
    const CouplingId id{static_cast<int>(e)};
    const CouplingTopology& coupling = mechanism.topology.couplings[e];
    const std::optional<BoundedWrench> wrench =
        is_by_convention(action, coupling) ? std::nullopt : bounded_wrench(action, id);
    const auto power_on = [&](BodyId body) {
      return wrench ? std::optional(power(*wrench, bounded_body(motion, body)).zeroed())
                    : std::nullopt;
    };
    flow.into_head.push_back(power_on(coupling.head));
    flow.out_of_tail.push_back(power_on(coupling.tail));
    const BoundedNumber supplied =
        wrench ? power(*wrench, bounded_coupling(mechanism, motion, id))
               : power_of_actuators_and_friction(mechanism, e, motion, action);
    flow.supplied.push_back(supplied.zeroed());
    sum = sum + supplied;
    if (wrench) {
      const Wrench& acts = *action.wrenches[e];
      rounding += rounding_of(terms_of(acts, Vec3::Zero()), motion.couplings[e]) +
                  unreported_power(mechanism, acts, motion.couplings[e]);
    }
    largest = std::max(
        {largest, std::abs(flow.into_head.back().value_or(0.0)), std::abs(flow.supplied.back())});
  }
  for (const Load& load : which.loads) {
    const auto body = static_cast<std::size_t>(load.acts.body.value);
    const BoundedNumber found = load_power(mechanism, load, motion);
    flow.loads.push_back(found.zeroed());
    sum = sum + found;
    const Wrench& acts = load.acts.wrench;
    rounding +=
        rounding_of(terms_of(acts, load.point.value_or(Vec3::Zero())), motion.bodies[body]) +
        unreported_power(mechanism, acts, motion.bodies[body]);
    largest = std::max(largest, std::abs(flow.loads.back()));
  }
  for (const ActuatorTopology& actuator : mechanism.topology.actuators) {
    flow.actuators.push_back(
        (bounded_action(action, actuator.action) * bounded_rate(motion, actuator.freedom))
            .zeroed());
  }
  for (const FrictionAction& friction : action.friction) {
    const BoundedNumber lost =
        power(written(friction.wrench), relative_motion(mechanism, friction, motion));
    flow.friction.push_back(lost.zeroed());
    if (friction.between) {
      sum = sum + lost;
    }
  }
  flow.input = input_power(which, flow);
  if (!flow.friction.empty()) {
    Efficiency found =
        find_efficiency(mechanism.topology,
                        which,
                        {.actuators = flow.actuators, .loads = flow.loads, .largest = largest});
    if (found.is_self_locking && is_taken_by_converters(mechanism, action, flow)) {
      found = {.value = std::nullopt,
               .reason = "the torque converter takes power from inputs and outputs"};
    }
    flow.efficiency = found.value;
    flow.no_efficiency = std::move(found.reason);
    flow.is_self_locking = found.is_self_locking;
  }
  flow.largest = largest;
  flow.balance_residual = largest == 0.0 ? 0.0 : std::abs(sum.value) / largest;
  flow.is_balanced = std::abs(sum.value) <= kPowerBalance * largest ||
                     zero_within_bound(sum.value, sum.bound + rounding) == 0.0;
  flow.error_bound = bound_of_powers(mechanism, motion, action, largest);
  return flow;
}

}  // namespace kinestat
