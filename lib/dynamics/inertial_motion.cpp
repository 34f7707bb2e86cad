#include "dynamics/inertial_motion.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "core/index.hpp"
#include "core/tolerance.hpp"
#include "dynamics/body_inertia.hpp"

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

// Of a unit rate of one drive, or of one idle freedom, everything else at rest.
std::vector<Twist> unit_motion(MotionStates& states,
                               const Configuration& configuration,
                               std::size_t drive_count,
                               std::optional<std::size_t> drive,
                               std::vector<PassiveSpeed> passive) {
  GivenSpeeds speeds{.drives = std::vector<DriveSpeed>(drive_count), .passive = std::move(passive)};
  if (drive) {
    speeds.drives[*drive].speed = 1.0;
  }
  return states.solve(configuration, speeds, StateDetail::velocity).twists;
}

double generalised_force(std::span<const Load> loads, const std::vector<Twist>& motion) {
  double sum = 0.0;
  for (const Load& load : loads) {
    sum += power(load.acts.wrench, motion[at(load.acts.body.value)]);
  }
  return sum;
}

}  // namespace

std::optional<InertialMotion> find_inertial_motion(const MotionNetwork& network,
                                                   MotionStates& states,
                                                   const Configuration& configuration,
                                                   const GivenSpeeds& speeds) {
  MotionState state = states.solve_bounded(configuration, speeds, StateDetail::acceleration);
  if (state.is_singular || state.twist_rates.empty()) {
    return std::nullopt;
  }
  InertialMotion motion{.poses = std::move(state.poses),
                        .twists = std::move(state.twists),
                        .twist_rates = std::move(state.twist_rates),
                        .bounds = std::move(state.bounds.bodies),
                        .drives = network.driven_freedoms,
                        .rates = {},
                        .accelerations = {},
                        .of_drives = {},
                        .of_idle = {}};
  std::vector<PassiveSpeed> at_rest;
  for (const int freedom : network.passive_freedoms) {
    at_rest.push_back({.freedom = freedom, .speed = 0.0});
  }
  const std::size_t count = speeds.drives.size();
  for (std::size_t d = 0; d < count; ++d) {
    motion.rates.push_back(speeds.drives[d].speed);
    motion.accelerations.push_back(speeds.drives[d].acceleration);
    motion.of_drives.push_back(unit_motion(states, configuration, count, d, at_rest));
  }
  for (std::size_t p = 0; p < at_rest.size(); ++p) {
    std::vector<PassiveSpeed> one = at_rest;
    one[p].speed = 1.0;
    motion.of_idle.push_back(
        unit_motion(states, configuration, count, std::nullopt, std::move(one)));
  }
  return motion;
}

std::variant<InertialMotion, InertiaObstacle> find_drawn_motion(const Mechanism& mechanism,
                                                                const Case& which,
                                                                const KinematicSolution& motion) {
  using enum InertiaObstacle::Kind;
  if (motion.status != SolveStatus::solved) {
    return InertiaObstacle{.kind = unknown_motion};
  }
  const MotionNetwork network =
      make_motion_network(mechanism, mechanism.drawn_couplings, drives_of(which));
  if (!network.is_movable()) {
    return obstacle_of(network);
  }
  MotionStates states(network, mechanism);
  std::optional<InertialMotion> found =
      find_inertial_motion(network, states, drawn_configuration(network), speeds_of(which));
  if (!found) {
    return InertiaObstacle{.kind = singular};
  }
  settle_idle_motions(mechanism, which, *found);
  return *std::move(found);
}

std::vector<Load> inertial_loads(const Mechanism& mechanism, const InertialMotion& motion) {
  std::vector<Load> loads;
  for (std::size_t b = 0; b < mechanism.masses.size(); ++b) {
    const BodyMass& mass = mechanism.masses[b];
    if (!mass.counts()) {
      continue;
    }
    const BodyInertia body = inertia_at(mass, motion.poses[b]);
    loads.push_back(
        {.name = std::string(kInertiaPrefix) + mechanism.topology.bodies[b].name,
         .acts = {.body = BodyId{static_cast<int>(b)},
                  .wrench = inertial_wrench(
                                body, motion.twists[b], motion.twist_rates[b], motion.bounds[b])
                                .zeroed()},
         .point = body.centre,
         .where = mass.where});
  }
  return loads;
}

void settle_idle_motions(const Mechanism& mechanism, const Case& which, InertialMotion& motion) {
  const auto count = static_cast<Eigen::Index>(motion.of_idle.size());
  if (count == 0) {
    return;
  }
  const std::vector<Load> inertial = inertial_loads(mechanism, motion);
  MatX inertia = MatX::Zero(count, count);
  VecX force = VecX::Zero(count);
  for (Eigen::Index p = 0; p < count; ++p) {
    const std::vector<Twist>& one = motion.of_idle[static_cast<std::size_t>(p)];
    force[p] = generalised_force(which.loads, one) + generalised_force(inertial, one);
    for (std::size_t b = 0; b < mechanism.masses.size(); ++b) {
      const BodyInertia body = inertia_at(mechanism.masses[b], motion.poses[b]);
      for (Eigen::Index q = 0; q < count; ++q) {
        inertia(p, q) +=
            shared_inertia(body, one[b], motion.of_idle[static_cast<std::size_t>(q)][b]);
      }
    }
  }
  // Idle motions of bodies without inertia have none, and ask for nothing.
  const VecX acceleration = Eigen::CompleteOrthogonalDecomposition<MatX>(inertia).solve(force);
  for (Eigen::Index p = 0; p < count; ++p) {
    const std::vector<Twist>& one = motion.of_idle[static_cast<std::size_t>(p)];
    for (std::size_t b = 0; b < one.size(); ++b) {
      motion.twist_rates[b] = motion.twist_rates[b] + acceleration[p] * one[b];
    }
  }
}

}  // namespace kinestat
