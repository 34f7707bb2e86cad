#include "dynamics/inertial_motion.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "core/index.hpp"
#include "core/tolerance.hpp"

namespace kinestat {

namespace {

std::vector<int> drives_of(const Case& which) {
  std::vector<int> drives;
  for (const Primary& known : which.motions) {
    if (!known.is_assumed) {
      drives.push_back(known.index);
    }
  }
  return drives;
}

GivenSpeeds speeds_of(const Case& which) {
  GivenSpeeds given;
  for (const Primary& known : which.motions) {
    if (known.is_assumed) {
      given.passive.push_back({.freedom = known.index, .speed = known.value});
    } else {
      given.drives.push_back({.speed = known.value,
                              .acceleration = acceleration_of(which, known.index),
                              .speed_bound = 0.0,
                              .acceleration_bound = 0.0});
    }
  }
  return given;
}

InertiaObstacle obstacle_of(const MotionNetwork& network) {
  const UnmovableCoupling& first = network.obstacles.front();
  return {.kind = InertiaObstacle::Kind::unmovable, .coupling = first};
}

std::vector<InertialBody> inertial_bodies(const Mechanism& mechanism, const MotionState& state) {
  std::vector<InertialBody> bodies;
  bodies.reserve(mechanism.masses.size());
  for (std::size_t b = 0; b < mechanism.masses.size(); ++b) {
    if (mechanism.masses[b].counts()) {
      const BodyInertia body = inertia_at(mechanism.masses[b], state.poses[b]);
      const BoundedWrench bounded =
          inertial_wrench(body, state.twists[b], state.twist_rates[b], state.bounds.bodies[b]);
      bodies.push_back({.body = BodyId{static_cast<int>(b)},
                        .inertia = body,
                        .bounded = bounded,
                        .acts = settled(bounded, body, state.bounds)});
    }
  }
  return bodies;
}

// What the bounds of accelerations leave open, but for rounding, over the largest force of inertia
// that bodies which turn so fast could have.
double open_share(const std::vector<InertialBody>& bodies,
                  const Mechanism& mechanism,
                  const MotionState& state) {
  const double rounding = state.bounds.rate_rate_rounding;
  const double reach = state.bounds.reach;
  double largest = 0.0;
  double open = 0.0;
  for (const InertialBody& one : bodies) {
    const auto b = at(one.body.value);
    const double turn = one.inertia.tensor.norm() / reach;
    const double spin = state.twists[b].angular.norm();
    const double speed = velocity_at(state.twists[b], one.inertia.centre).norm();
    const BoundedRate centre = point_acceleration(state, one.body, mechanism.masses[b].centre);
    const double of_centre = centre.value.norm() + spin * speed;
    const double of_turn = state.twist_rates[b].angular.norm() + spin * spin;
    largest = std::max({largest, one.inertia.mass * of_centre, turn * of_turn});
    if (state.bounds.bodies[b].angular_rate > rounding) {
      open = std::max(open, turn * state.bounds.bodies[b].angular_rate);
    }
    if (centre.bound > rounding * (reach + one.inertia.centre.norm())) {
      open = std::max(open, one.inertia.mass * centre.bound);
    }
  }
  return largest > 0.0 ? open / largest : 0.0;
}

// Of a unit rate of one drive, or of one idle freedom, everything else at rest.
MotionState unit_motion(MotionStates& states,
                        const Configuration& configuration,
                        std::size_t drive_count,
                        std::optional<std::size_t> drive,
                        std::vector<PassiveSpeed> passive) {
  GivenSpeeds speeds{.drives = std::vector<DriveSpeed>(drive_count), .passive = std::move(passive)};
  if (drive) {
    speeds.drives[*drive].speed = 1.0;
  }
  return states.solve_bounded(configuration, speeds, StateDetail::velocity);
}

// The first body whose inertia a motion of its own has to speed up.
std::optional<BodyId> find_spinning_body(const std::vector<InertialBody>& bodies,
                                         const std::vector<Twist>& idle,
                                         double length) {
  double fastest = 0.0;
  for (const Twist& one : idle) {
    fastest =
        std::max(fastest, one.angular.squaredNorm() + one.linear.squaredNorm() / (length * length));
  }
  for (const InertialBody& one : bodies) {
    const double most = (one.inertia.tensor.norm() + one.inertia.mass * length * length) * fastest;
    const Twist& moves = idle[at(one.body.value)];
    if (shared_inertia(one.inertia, moves, moves) > kIdleInertia * most) {
      return one.body;
    }
  }
  return std::nullopt;
}

}  // namespace

std::variant<InertialMotion, InertiaObstacle> find_inertial_motion(
    const Mechanism& mechanism,
    const MotionNetwork& network,
    MotionStates& states,
    const Configuration& configuration,
    const GivenSpeeds& speeds) {
  return inertial_motion_of(states.solve_bounded(configuration, speeds, StateDetail::acceleration),
                            mechanism,
                            network,
                            states,
                            configuration,
                            speeds,
                            InertiaDetail::equation);
}

std::variant<InertialMotion, InertiaObstacle> inertial_motion_of(const MotionState& state,
                                                                 const Mechanism& mechanism,
                                                                 const MotionNetwork& network,
                                                                 MotionStates& states,
                                                                 const Configuration& configuration,
                                                                 const GivenSpeeds& speeds,
                                                                 InertiaDetail detail) {
  if (state.is_singular || state.twist_rates.empty()) {
    return InertiaObstacle{.kind = InertiaObstacle::Kind::singular};
  }
  std::vector<InertialBody> bodies = inertial_bodies(mechanism, state);
  const double share = open_share(bodies, mechanism, state);
  InertialMotion motion{.twists = state.twists,
                        .twist_rates = state.twist_rates,
                        .bounds = state.bounds.bodies,
                        .inertial = std::move(bodies),
                        .open_share = share,
                        .drives = network.driven_freedoms,
                        .rates = {},
                        .accelerations = {},
                        .of_drives = {},
                        .drive_bounds = {}};
  std::vector<PassiveSpeed> at_rest;
  for (const int freedom : network.passive_freedoms) {
    at_rest.push_back({.freedom = freedom, .speed = 0.0});
  }
  const std::size_t count = speeds.drives.size();
  for (std::size_t p = 0; p < at_rest.size(); ++p) {
    std::vector<PassiveSpeed> one = at_rest;
    one[p].speed = 1.0;
    const std::vector<Twist> idle =
        unit_motion(states, configuration, count, std::nullopt, std::move(one)).twists;
    if (const std::optional<BodyId> body =
            find_spinning_body(motion.inertial, idle, mechanism.geometry.length)) {
      return InertiaObstacle{.kind = InertiaObstacle::Kind::idle_spin, .body = body};
    }
  }
  for (std::size_t d = 0; d < count; ++d) {
    motion.rates.push_back(speeds.drives[d].speed);
    motion.accelerations.push_back(speeds.drives[d].acceleration);
  }
  for (std::size_t d = 0; detail == InertiaDetail::equation && d < count; ++d) {
    MotionState unit = unit_motion(states, configuration, count, d, at_rest);
    motion.of_drives.push_back(std::move(unit.twists));
    motion.drive_bounds.push_back(std::move(unit.bounds.bodies));
  }
  return motion;
}

std::variant<InertialMotion, InertiaObstacle> find_drawn_motion(const Mechanism& mechanism,
                                                                const Case& which,
                                                                const KinematicSolution& motion) {
  if (motion.status != SolveStatus::solved) {
    return InertiaObstacle{.kind = InertiaObstacle::Kind::unknown_motion};
  }
  const MotionNetwork network =
      make_motion_network(mechanism, mechanism.drawn_couplings, drives_of(which));
  if (!network.is_movable()) {
    return obstacle_of(network);
  }
  MotionStates states(network, mechanism);
  return find_inertial_motion(
      mechanism, network, states, drawn_configuration(network), speeds_of(which));
}

std::vector<std::string> inertial_load_names(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (std::size_t b = 0; b < mechanism.masses.size(); ++b) {
    if (mechanism.masses[b].counts()) {
      names.push_back(std::string(kInertiaPrefix) + mechanism.topology.bodies[b].name);
    }
  }
  return names;
}

std::vector<Load> inertial_loads(const Mechanism& mechanism, const InertialMotion& motion) {
  std::vector<Load> loads;
  loads.reserve(motion.inertial.size());
  for (const InertialBody& one : motion.inertial) {
    loads.push_back({.name = std::string(kInertiaPrefix) + mechanism.topology.body(one.body).name,
                     .acts = {.body = one.body, .wrench = one.acts},
                     .point = one.inertia.centre,
                     .where = mechanism.masses[at(one.body.value)].where});
  }
  return loads;
}

}  // namespace kinestat
