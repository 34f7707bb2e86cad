#include "power/transmission_angle.hpp"

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "core/tolerance.hpp"
#include "network/bases.hpp"
#include "statics/action.hpp"

namespace kinestat {

namespace {

using AngleOrObstacle = std::variant<double, TransmissionObstacle>;

// The coupling through which the output is driven, and how its wrench counts on the driven body.
struct DrivingCoupling {
  CouplingId coupling;
  double sign = 1.0;  ///< -1: the driven body is the tail
};

// The body that the output moves: of two moving ones the head.
BodyId driven_body(const CouplingTopology& output) {
  return output.head.value != 0 ? output.head : output.tail;
}

BodyId holding_body(const CouplingTopology& output) {
  return output.head.value != 0 ? output.tail : output.head;
}

std::optional<DrivingCoupling> find_driving_coupling(const Topology& topology,
                                                     const CouplingTopology& output) {
  const BodyId driven = driven_body(output);
  const BodyId holding = holding_body(output);
  std::optional<DrivingCoupling> result;
  for (int c = 0; c < topology.coupling_count(); ++c) {
    const CouplingTopology& one = topology.coupling({c});
    const bool is_head = one.head == driven;
    const bool is_joined = is_head || one.tail == driven;
    const BodyId other = is_head ? one.tail : one.head;
    if (!is_joined || other == holding || one.action_count == 0) {
      continue;
    }
    if (result) {
      return std::nullopt;
    }
    result = DrivingCoupling{.coupling = {c}, .sign = is_head ? 1.0 : -1.0};
  }
  return result;
}

// The wrench of the driving coupling while one actuator bears 1, one follows from it and the others
// bear nothing.
std::optional<Wrench> find_driving_wrench(const Mechanism& mechanism,
                                          const CoordinateBasis& basis,
                                          const DrivingCoupling& driving,
                                          int loaded,
                                          int following) {
  const std::vector<ActuatorTopology>& actuators = mechanism.topology.actuators;
  std::vector<Primary> known;
  for (int i = 0; i < static_cast<int>(actuators.size()); ++i) {
    if (i != following) {
      known.push_back({.index = actuators[static_cast<std::size_t>(i)].action,
                       .value = i == loaded ? 1.0 : 0.0,
                       .given = {},
                       .where = {}});
    }
  }
  const StaticSolution solution = solve_action(mechanism, basis, known);
  const auto at = static_cast<std::size_t>(driving.coupling.value);
  return solution.wrenches.empty() || !solution.wrenches[at]
             ? std::nullopt
             : std::optional(driving.sign * *solution.wrenches[at]);
}

// Of a force and the motion of the body on which it acts; `near` is the point of the coupling.
AngleOrObstacle angle_between(const Wrench& wrench,
                              const Twist& motion,
                              const Vec3& near,
                              double length) {
  const double force = wrench.force.norm();
  const Vec3 moment = moment_at(wrench, near);
  if (force * length <= kNoReaction * moment.norm()) {
    return TransmissionObstacle::couple;  // It has no line.
  }
  // The point of the line of F next to the coupling.
  const Vec3 point = near + wrench.force.cross(moment) / (force * force);
  const Vec3 velocity = velocity_at(motion, point);
  const double fastest = std::max(motion.linear.norm(), motion.angular.norm() * length);
  if (velocity.norm() <= kNoReaction * fastest) {
    return TransmissionObstacle::rest;
  }
  const double along = std::abs(wrench.force.dot(velocity));
  return std::atan2(along, wrench.force.cross(velocity).norm());
}

AngleOrObstacle find_angle(const Mechanism& mechanism, int input, int output) {
  if (input == output) {
    return TransmissionObstacle::same_actuator;
  }
  const Topology& topology = mechanism.topology;
  const ActuatorTopology& driven = topology.actuators[static_cast<std::size_t>(output)];
  const auto freedom = static_cast<std::size_t>(driven.freedom);
  const CouplingTopology& coupling = topology.coupling(topology.freedoms[freedom].coupling);
  const std::optional<DrivingCoupling> driving = find_driving_coupling(topology, coupling);
  if (!driving) {
    return TransmissionObstacle::no_one_coupling;
  }
  const CoordinateBasis basis = action_basis(mechanism.geometry, mechanism.static_order);
  std::optional<Wrench> wrench = find_driving_wrench(mechanism, basis, *driving, output, input);
  if (!wrench) {  // At a dead point of the input only the input can load the chain.
    wrench = find_driving_wrench(mechanism, basis, *driving, input, output);
  }
  if (!wrench) {
    return TransmissionObstacle::open_force;
  }
  const auto at = static_cast<std::size_t>(driving->coupling.value);
  return angle_between(*wrench,
                       mechanism.geometry.motions[freedom],
                       mechanism.geometry.points[at] - mechanism.geometry.origin,
                       mechanism.geometry.length);
}

}  // namespace

std::optional<double> find_transmission_angle(const Mechanism& mechanism, int input, int output) {
  const AngleOrObstacle found = find_angle(mechanism, input, output);
  const double* angle = std::get_if<double>(&found);
  return angle == nullptr ? std::nullopt : std::optional(*angle);
}

std::optional<TransmissionObstacle> find_transmission_obstacle(const Mechanism& mechanism,
                                                               int input,
                                                               int output) {
  const AngleOrObstacle found = find_angle(mechanism, input, output);
  const auto* obstacle = std::get_if<TransmissionObstacle>(&found);
  return obstacle == nullptr ? std::nullopt : std::optional(*obstacle);
}

}  // namespace kinestat
