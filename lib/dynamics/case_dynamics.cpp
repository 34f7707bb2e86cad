#include "dynamics/case_dynamics.hpp"

#include <algorithm>
#include <cmath>

#include "core/index.hpp"
#include "dynamics/planet_inertia.hpp"

namespace kinestat {

namespace {

bool has_answer(const StaticSolution* action) {
  return action != nullptr && !action->magnitudes.empty();
}

// The action of head and tail on each other has the power of this motion.
Twist relative(const std::vector<Twist>& bodies, BodyId tail, BodyId head) {
  return bodies[at(head.value)] - bodies[at(tail.value)];
}

BoundedTwist bounded_twist(const Twist& twist, const BodyBounds& bounds) {
  return {.angular = {.value = twist.angular, .bound = Vec3::Constant(bounds.angular)},
          .linear = {.value = twist.linear, .bound = Vec3::Constant(bounds.linear)}};
}

ReducedEquation find_reduced(const InertialMotion& motion) {
  const auto count = static_cast<Eigen::Index>(motion.drives.size());
  ReducedEquation result{.drives = motion.drives,
                         .accelerations = motion.accelerations,
                         .inertia = MatX::Zero(count, count),
                         .bias = VecX::Zero(count),
                         .derivative = {}};
  std::vector<BoundedNumber> bias(static_cast<std::size_t>(count));
  for (const auto& [id, body, bounded, acts] : motion.inertial) {
    const std::size_t b = at(id.value);
    std::vector<BoundedTwist> twists;
    std::vector<BoundedWrench> momenta;
    for (std::size_t d = 0; d < motion.drives.size(); ++d) {
      const Twist& twist = motion.of_drives[d][b];
      twists.push_back(bounded_twist(twist, motion.drive_bounds[d][b]));
      momenta.push_back(momentum(body, twist, motion.drive_bounds[d][b]));
    }
    for (int j = 0; j < count; ++j) {
      const BoundedTwist& of_drive = twists[at(j)];
      BoundedNumber& sum = bias[at(j)];
      sum = sum - power(bounded, of_drive);
      for (int k = 0; k < count; ++k) {
        const BoundedNumber shared = power(momenta[at(k)], of_drive);
        result.inertia(j, k) += shared.value;
        sum = sum - BoundedNumber{.value = motion.accelerations[at(k)], .bound = 0.0} * shared;
      }
    }
  }
  for (int j = 0; j < count; ++j) {
    result.bias[j] = bias[at(j)].zeroed();
  }
  if (count == 1 && motion.rates.front() != 0.0) {
    result.derivative = 2.0 * result.bias[0] / (motion.rates.front() * motion.rates.front());
  }
  return result;
}

// By virtual power: actuators, friction and loads alone, no passive constraint.
std::optional<double> compare_two_ways(const Mechanism& mechanism,
                                       const Case& which,
                                       const InertialMotion& motion,
                                       const StaticSolution& action) {
  const Topology& topology = mechanism.topology;
  double worst = 0.0;
  for (const std::vector<Twist>& bodies : motion.of_drives) {
    double sum = 0.0;
    double largest = 0.0;
    const auto add = [&](double term) {
      sum += term;
      largest = std::max(largest, std::abs(term));
    };
    for (const Load& load : which.loads) {
      add(power(load.acts.wrench, bodies[at(load.acts.body.value)]));
    }
    for (const ActuatorTopology& actuator : topology.actuators) {
      const std::optional<double>& magnitude = action.magnitudes[at(actuator.action)];
      const CouplingTopology& coupling =
          topology.coupling(topology.actions[at(actuator.action)].coupling);
      const double rate = power(mechanism.geometry.actions[at(actuator.action)],
                                relative(bodies, coupling.tail, coupling.head));
      if (!magnitude) {
        return std::nullopt;
      }
      add(*magnitude * rate);
    }
    for (const FrictionAction& friction : action.friction) {
      const CouplingTopology& coupling = topology.coupling(friction.coupling);
      const BodyId tail = friction.between ? friction.between->tail : coupling.tail;
      const BodyId head = friction.between ? friction.between->head : coupling.head;
      add(power(friction.wrench, relative(bodies, tail, head)));
    }
    worst = largest > 0.0 ? std::max(worst, std::abs(sum) / largest) : worst;
  }
  return worst;
}

int count_of(const Mechanism& mechanism, BodyId body) {
  return mechanism.masses.empty() ? 1 : mechanism.masses[at(body.value)].count;
}

// All loads on the moving bodies but those of springs, which join them with each other or the
// ground. Nothing says at how many planets a load acts.
std::optional<Wrench> find_ground(const Mechanism& mechanism,
                                  const Case& which,
                                  const std::optional<BoundedWrench>& shaking) {
  std::optional<BoundedWrench> sum = shaking;
  for (const Load& load : which.loads) {
    if (!sum || load.name.starts_with(kSpringPrefix) || load.name.starts_with(kInertiaPrefix)) {
      continue;
    }
    const bool is_on_planets = count_of(mechanism, load.acts.body) > 1;
    sum = is_on_planets ? std::nullopt : std::optional(*sum + written(load.acts.wrench));
  }
  return sum ? std::optional(sum->zeroed()) : std::nullopt;
}

// Planets that stand for several where they are.
std::optional<BoundedWrench> shaking_of(const Mechanism& mechanism,
                                        BodyId body,
                                        const BodyInertia& inertia,
                                        const BoundedWrench& drawn,
                                        const InertialMotion& motion) {
  if (count_of(mechanism, body) == 1) {
    return drawn;
  }
  const std::optional<PlanetAxis> axis = axis_of_planets(mechanism, body);
  return axis ? spread_planets(drawn, *axis, inertia, motion) : std::nullopt;
}

}  // namespace

CaseDynamics find_dynamics(const Mechanism& mechanism,
                           const Case& which,
                           const InertialMotion& motion,
                           const StaticSolution* action) {
  CaseDynamics result;
  result.open_share = motion.open_share;
  result.bodies.reserve(motion.inertial.size());
  std::optional<BoundedWrench> shaking = BoundedWrench{};
  for (const auto& [id, body, bounded, acts] : motion.inertial) {
    const std::size_t b = at(id.value);
    const Twist& twist = motion.twists[b];
    const Twist& rate = motion.twist_rates[b];
    result.bodies.push_back({.body = id,
                             .angular_acceleration = rate.angular,
                             .angular_bound = motion.bounds[b].angular_rate,
                             .centre = body.centre,
                             .centre_acceleration = centre_acceleration(body, twist, rate),
                             .inertial = acts,
                             .kinetic_energy = kinetic_energy(body, twist)});
    result.kinetic_energy += result.bodies.back().kinetic_energy;
    result.kinetic_energy_rate -= power(acts, twist);
    const auto shakes = shaking_of(mechanism, id, body, bounded, motion);
    shaking = shaking && shakes ? std::optional(*shaking + *shakes) : std::nullopt;
  }
  if (shaking) {
    result.shaking = shaking->zeroed();
  }
  const bool knows_drives = motion.of_drives.size() == motion.drives.size();
  if (knows_drives) {
    result.reduced = find_reduced(motion);
  }
  if (has_answer(action)) {
    result.ground = find_ground(mechanism, which, shaking);
    result.two_ways =
        knows_drives ? compare_two_ways(mechanism, which, motion, *action) : std::nullopt;
  }
  return result;
}

}  // namespace kinestat
