#include "power/transmission_angle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>
#include <vector>

#include "mechanism/position_error.hpp"
#include "network/bases.hpp"
#include "statics/action.hpp"
#include "statics/coupling_wrenches.hpp"

namespace kinestat {

namespace {

using AngleOrObstacle = std::variant<double, TransmissionObstacle>;

// The body that the output moves: of two moving ones the head.
BodyId driven_body(const CouplingTopology& output) {
  return output.head.value != 0 ? output.head : output.tail;
}

BodyId holding_body(const CouplingTopology& output) {
  return output.head.value != 0 ? output.tail : output.head;
}

// Those that may drive the body of the output.
std::vector<CouplingId> find_driving_couplings(const Topology& topology,
                                               const CouplingTopology& output) {
  const BodyId driven = driven_body(output);
  const BodyId holding = holding_body(output);
  std::vector<CouplingId> result;
  for (int c = 0; c < topology.coupling_count(); ++c) {
    const CouplingTopology& one = topology.coupling({c});
    const bool is_head = one.head == driven;
    const bool is_joined = is_head || one.tail == driven;
    const BodyId other = is_head ? one.tail : one.head;
    if (!is_joined || other == holding || one.action_count == 0) {
      continue;
    }
    result.push_back(CouplingId{c});
  }
  return result;
}

// What a coupling does to the body of the output.
struct Drive {
  CouplingId coupling;
  BoundedWrench wrench;
};

// What drives while the action `loaded` is 1, input and output bear what follows from it, and the
// other actuators nothing, those alone excepted that equilibrium gives an action by itself;
// couplings that bear nothing are left out.
std::optional<std::vector<Drive>> find_drives(const Mechanism& mechanism,
                                              const CoordinateBasis& basis,
                                              std::span<const CouplingId> driving,
                                              int loaded,
                                              const std::array<int, 2>& ends) {
  std::vector<Primary> known = {{.index = loaded, .value = 1.0, .given = {}, .where = {}}};
  StaticSolution solution = solve_action(mechanism, basis, known);
  for (const ActuatorTopology& actuator : mechanism.topology.actuators) {
    const bool is_open = solution.status == SolveStatus::underdetermined &&
                         !solution.magnitudes[static_cast<std::size_t>(actuator.action)];
    if (is_open && std::ranges::find(ends, actuator.action) == ends.end()) {
      known.push_back({.index = actuator.action, .value = 0.0, .given = {}, .where = {}});
      solution = solve_action(mechanism, basis, known);
    }
  }
  std::vector<Drive> drives;
  for (const CouplingId coupling : driving) {
    const std::optional<BoundedWrench> wrench =
        solution.wrenches.empty() ? std::nullopt : bounded_wrench(solution, coupling);
    if (!wrench) {
      return std::nullopt;
    }
    if (!wrench->zeroed().coordinates().isZero(0.0)) {
      drives.push_back({.coupling = coupling, .wrench = *wrench});
    }
  }
  return drives.empty() ? std::nullopt : std::optional(std::move(drives));
}

// While the output is loaded; at a dead point of the input, where only that can load the chain,
// while the input is; and where the chain is stretched so that neither can, as it stresses itself,
// which is the limit of what is beside that position.
std::optional<std::vector<Drive>> find_drives(const Mechanism& mechanism,
                                              std::span<const CouplingId> driving,
                                              int input,
                                              int output) {
  const CoordinateBasis basis = action_basis(mechanism.geometry, mechanism.static_order);
  std::vector<int> loaded = {output, input};
  for (const CouplingId id : driving) {
    const CouplingTopology& coupling = mechanism.topology.coupling(id);
    for (int i = 0; i < coupling.action_count; ++i) {
      loaded.push_back(coupling.first_action + i);
    }
  }
  std::optional<std::vector<Drive>> drives;
  for (std::size_t i = 0; i < loaded.size() && !drives; ++i) {
    drives = find_drives(mechanism, basis, driving, loaded[i], {input, output});
  }
  return drives;
}

// Of a force and the motion of the body on which it acts, in whatever sense; `near` is the point of
// the coupling, and `misplaced` is how far points may be off.
AngleOrObstacle angle_between(const BoundedWrench& wrench,
                              const Twist& motion,
                              const Vec3& near,
                              double misplaced) {
  const BoundedVector& force = wrench.force;
  const BoundedVector moment = moment_at(wrench, near);
  const BoundedNumber square = dot(force, force);
  if (square.zeroed() == 0.0) {
    return TransmissionObstacle::couple;  // It has no line, or none that is known.
  }
  // The point of the line of F next to the coupling.
  const BoundedNumber one = {.value = 1.0, .bound = 0.0};
  const BoundedVector arm = (one / square) * cross(force, moment);
  const BoundedVector place = {.value = Vec3::Zero(), .bound = Vec3::Constant(misplaced)};
  const BoundedTwist turning = written(motion);
  const BoundedVector velocity = velocity_at(turning, near) + cross(turning.angular, arm + place);
  if (velocity.zeroed().isZero(0.0)) {
    return TransmissionObstacle::rest;
  }
  const double along = std::abs(dot(force, velocity).zeroed());
  return std::atan2(along, force.value.cross(velocity.value).norm());
}

AngleOrObstacle find_angle(const Mechanism& mechanism, int input, int output) {
  if (input == output) {
    return TransmissionObstacle::same_actuator;
  }
  const Topology& topology = mechanism.topology;
  const ActuatorTopology& driven = topology.actuators[static_cast<std::size_t>(output)];
  const auto freedom = static_cast<std::size_t>(driven.freedom);
  const CouplingTopology& coupling = topology.coupling(topology.freedoms[freedom].coupling);
  const std::vector<CouplingId> driving = find_driving_couplings(topology, coupling);
  if (driving.empty()) {
    return TransmissionObstacle::no_one_coupling;
  }
  const std::optional<std::vector<Drive>> drives =
      find_drives(mechanism,
                  driving,
                  topology.actuators[static_cast<std::size_t>(input)].action,
                  driven.action);
  if (!drives) {
    return driving.size() > 1 ? TransmissionObstacle::no_one_coupling
                              : TransmissionObstacle::open_force;
  }
  if (drives->size() > 1) {
    return TransmissionObstacle::no_one_coupling;
  }
  const auto at = static_cast<std::size_t>(drives->front().coupling.value);
  return angle_between(drives->front().wrench,
                       mechanism.geometry.motions[freedom],
                       mechanism.geometry.points[at],
                       position_error(mechanism) * mechanism.geometry.length);
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
