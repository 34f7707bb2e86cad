#include "studies/simulation/reduced_system.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/index.hpp"
#include "core/simulation_tolerance.hpp"
#include "dynamics/body_inertia.hpp"
#include "math/dense/dense_solve.hpp"
#include "mechanism/cases/moved_load.hpp"

namespace kinestat {

namespace {

// The sizes of the terms of its power, whatever point it is written about.
double power_size(const Wrench& wrench, const Twist& twist, double length) {
  return wrench.force.norm() * (twist.linear.norm() + twist.angular.norm() * length) +
         wrench.moment.norm() * twist.angular.norm();
}

bool is_weight(const Load& load) {
  return load.name.starts_with(kWeightPrefix);
}

// To a coordinate.
void add_force(double force, std::size_t drive, VecX& forces, VecX& sizes) {
  forces[static_cast<Eigen::Index>(drive)] += force;
  sizes[static_cast<Eigen::Index>(drive)] += std::abs(force);
}

std::vector<std::optional<double>> settled_positions(MotionStates& states,
                                                     const Configuration& configuration,
                                                     const MotionState& state) {
  auto positions = states.freedom_positions(configuration);
  settle_positions(state.bounds, positions);
  return positions;
}

double kinetic_of(const Mechanism& mechanism, const MotionState& state) {
  double sum = 0.0;
  for (std::size_t b = 0; b < mechanism.masses.size(); ++b) {
    if (mechanism.masses[b].counts()) {
      sum += kinetic_energy(inertia_at(mechanism.masses[b], state.poses[b]), state.twists[b]);
    }
  }
  return sum;
}

}  // namespace

ReducedSystem::ReducedSystem(const Mechanism& mechanism,
                             const Case& which,
                             MotionNetwork network,
                             std::size_t free_count,
                             StateBalance* balance)
    : mechanism_(mechanism),
      which_(which),
      network_(std::move(network)),
      free_count_(free_count),
      follower_(network_),
      states_(network_, mechanism),
      needs_place_(which.follows_curves() || !mechanism.springs.empty()),
      balance_(balance),
      frictions_(find_rubbing(mechanism)),
      friction_(frictions_.size()),
      inertial_(mechanism.masses.size()),
      carried_(mechanism.masses.size()) {
  const std::size_t count = network_.driven_rates.size();
  speeds_.drives.resize(count);
  for (const int freedom : network_.passive_freedoms) {
    speeds_.passive.push_back({.freedom = freedom, .speed = 0.0});
  }
  units_.resize(count);
  held_.resize(count - free_count);
}

void ReducedSystem::set_friction(std::vector<FrictionSense> senses, bool is_open) {
  senses_ = std::move(senses);
  is_open_ = is_open;
}

void ReducedSystem::set_speeds(std::span<const double> speeds,
                               std::span<const double> accelerations) {
  for (std::size_t d = 0; d < speeds_.drives.size(); ++d) {
    speeds_.drives[d] = {.speed = speeds[d],
                         .acceleration = d < accelerations.size() ? accelerations[d] : 0.0};
  }
}

bool ReducedSystem::accelerate(double time,
                               const Configuration& configuration,
                               std::span<const double> speeds,
                               std::span<double> accelerations) {
  const std::size_t count = speeds_.drives.size();
  set_speeds(speeds, {});
  state_ = states_.solve(configuration, speeds_, StateDetail::acceleration);
  if (state_.is_singular || state_.twist_rates.empty()) {
    return fail(SimulationObstacle::Kind::singular);
  }
  for (std::size_t d = 0; d < count; ++d) {
    for (std::size_t k = 0; k < count; ++k) {
      speeds_.drives[k] = {.speed = k == d ? 1.0 : 0.0};
    }
    units_[d] = states_.solve(configuration, speeds_, StateDetail::velocity);
  }
  if (const std::optional<BodyId> rotor = wrong_rotor()) {
    obstacle_ = {.kind = SimulationObstacle::Kind::rotor, .body = rotor};
    return false;
  }
  forces_ = VecX::Zero(static_cast<Eigen::Index>(count));
  sizes_ = forces_;
  add_inertia();
  powers_ = {};
  loads_.clear();
  rubbing_.clear();
  if (balance_ != nullptr) {
    balance_->place(configuration, state_.poses, 0.0);
  }
  if (!add_forces(time, configuration)) {
    return false;
  }
  const auto free = static_cast<Eigen::Index>(free_count_);
  std::optional<VecX> solved = VecX();
  if (free > 0) {
    solved = solve_dense(inertia_.topLeftCorner(free, free), forces_.head(free) - bias_.head(free));
  }
  if (!solved) {
    return fail(SimulationObstacle::Kind::no_inertia);
  }
  VecX& found = *solved;
  if (!add_friction(found)) {
    return false;
  }
  std::copy_n(found.data(), free_count_, accelerations.begin());
  held_ = held_with(found);
  for (std::size_t k = 0; k < held_.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(free_count_ + k);
    const double size = sizes_[row] + inertia_.row(row).head(free).cwiseAbs().dot(found.cwiseAbs());
    held_[k] = std::abs(held_[k]) <= kNoHold * size ? 0.0 : held_[k];
    powers_.supplied += held_[k] * speeds[free_count_ + k];
  }
  return true;
}

void ReducedSystem::add_inertia() {
  const auto count = static_cast<Eigen::Index>(units_.size());
  inertia_ = MatX::Zero(count, count);
  bias_ = VecX::Zero(count);
  for (std::size_t b = 0; b < mechanism_.masses.size(); ++b) {
    if (!mechanism_.masses[b].counts()) {
      continue;
    }
    const BodyInertia body = inertia_at(mechanism_.masses[b], state_.poses[b]);
    const BoundedWrench acts =
        inertial_wrench(body, state_.twists[b], state_.twist_rates[b], BodyBounds{});
    const Wrench wrench{.moment = acts.moment.value, .force = acts.force.value};
    inertial_[b] = wrench;
    carried_[b].resize(units_.size());
    for (Eigen::Index j = 0; j < count; ++j) {
      const Twist& unit = units_[static_cast<std::size_t>(j)].twists[b];
      bias_[j] -= power(wrench, unit);
      sizes_[j] += power_size(wrench, unit, mechanism_.geometry.length);
      const Wrench carried = momentum(body, unit);
      carried_[b][static_cast<std::size_t>(j)] = carried;
      for (Eigen::Index k = 0; k <= j; ++k) {
        inertia_(j, k) += power(carried, units_[static_cast<std::size_t>(k)].twists[b]);
      }
    }
  }
  inertia_ = inertia_.selfadjointView<Eigen::Lower>();
}

void ReducedSystem::add_wrench(BodyId body, const Wrench& wrench) {
  if (balance_ != nullptr) {
    loads_.push_back({.body = body, .wrench = wrench});
  }
  for (std::size_t j = 0; j < units_.size(); ++j) {
    const Twist& unit = units_[j].twists[at(body.value)];
    forces_[static_cast<Eigen::Index>(j)] += power(wrench, unit);
    sizes_[static_cast<Eigen::Index>(j)] += power_size(wrench, unit, mechanism_.geometry.length);
  }
}

double ReducedSystem::unit_rate(std::size_t drive, int freedom) const {
  return units_[drive].rates[at(freedom)].value_or(0.0);
}

bool ReducedSystem::add_forces(double time, const Configuration& configuration) {
  place_.time = time;
  if (needs_place_) {
    place_.poses = state_.poses;
    place_.twists = state_.twists;
    place_.rates = state_.rates;
    place_.positions = freedom_positions(network_, mechanism_, configuration);
  }
  for (std::size_t l = 0; l < which_.moving_loads.size(); ++l) {
    const MovingLoad& drawn = mechanism_.cases.front().moving_loads[l];
    move_load(drawn, state_.poses[at(drawn.body.value)], which_.moving_loads[l]);
  }
  const auto numbers = curve_numbers(mechanism_, which_, place_);
  if (const CurveObstacle* const none = std::get_if<CurveObstacle>(&numbers)) {
    obstacle_ = {.kind = SimulationObstacle::Kind::curve, .of_curve = *none};
    return false;
  }
  const CurveNumbers& known = std::get<CurveNumbers>(numbers);
  const auto springs = spring_states(mechanism_, place_, known.springs);
  if (const SpringObstacle* const none = std::get_if<SpringObstacle>(&springs)) {
    obstacle_ = {.kind = SimulationObstacle::Kind::spring, .of_spring = *none};
    return false;
  }
  springs_ = std::get<std::vector<SpringState>>(springs);
  spring_forces_ = known.springs;
  load_powers_.clear();
  for (const Load& load : which_.loads) {
    const std::size_t b = at(load.acts.body.value);
    const Wrench wrench = moved_wrench(load, state_.poses[b]);
    add_wrench(load.acts.body, wrench);
    load_powers_.push_back(power(wrench, state_.twists[b]));
    powers_.supplied += is_weight(load) ? 0.0 : load_powers_.back();
  }
  for (const Load& load : known.loads) {
    add_wrench(load.acts.body, load.acts.wrench);
    load_powers_.push_back(power(load.acts.wrench, state_.twists[at(load.acts.body.value)]));
    powers_.supplied += load_powers_.back();
  }
  actions_ = known.actions;
  for (std::size_t a = 0; a < actions_.size(); ++a) {
    const ActionLabel& label = mechanism_.topology.actions[at(which_.actions[a].index)];
    const int freedom = mechanism_.topology.actuators[at(label.actuator)].freedom;
    for (std::size_t j = 0; j < units_.size(); ++j) {
      add_force(actions_[a] * unit_rate(j, freedom), j, forces_, sizes_);
    }
    if (balance_ != nullptr) {
      balance_->add_pair(freedom, actions_[a], loads_);
    }
    powers_.supplied += actions_[a] * state_.rates[at(freedom)].value_or(0.0);
  }
  for (const CouplingFriction& friction : mechanism_.frictions) {
    const int freedom = mechanism_.topology.coupling(friction.coupling).first_freedom;
    const double rate = state_.rates[at(freedom)].value_or(0.0);
    const double viscous = friction.planets * friction.viscous;
    for (std::size_t j = 0; j < units_.size(); ++j) {
      add_force(-viscous * rate * unit_rate(j, freedom), j, forces_, sizes_);
    }
    powers_.lost += viscous * rate * rate;
    if (balance_ != nullptr && viscous != 0.0) {
      balance_->add_pair(freedom, -viscous * rate, loads_);
    }
  }
  add_springs(springs_, known.springs);
  if (balance_ != nullptr && !springs_.empty()) {
    for (const Load& load : spring_loads(balance_->moved(), place_, springs_)) {
      loads_.push_back(load.acts);
    }
  }
  return true;
}

void ReducedSystem::add_springs(const std::vector<SpringState>& springs,
                                std::span<const double> forces) {
  for (std::size_t i = 0; i < springs.size(); ++i) {
    const Spring& spring = mechanism_.springs[i];
    const SpringState& now = springs[i];
    // What its place changes by for a unit speed of each coordinate; its tension, or minus its
    // action, works against that.
    const double against = spring.is_of_freedom() ? -now.force : now.force;
    for (std::size_t j = 0; j < units_.size(); ++j) {
      double rate = 0.0;
      if (spring.is_of_freedom()) {
        rate = unit_rate(j, spring.freedom);
      } else {
        const Vec3 from = state_.poses[at(spring.tail.value)].point(spring.from);
        const Vec3 to = state_.poses[at(spring.head.value)].point(spring.to);
        const Vec3 speed = velocity_at(units_[j].twists[at(spring.head.value)], to) -
                           velocity_at(units_[j].twists[at(spring.tail.value)], from);
        rate = now.position > 0.0 ? speed.dot(to - from) / now.position : 0.0;  // of no force
      }
      add_force(-against * rate, j, forces_, sizes_);
    }
    const double taken = (against - elastic_tension(spring, now.position)) * now.rate;
    (forces[i] == 0.0 ? powers_.lost : powers_.supplied) += forces[i] == 0.0 ? taken : -taken;
  }
}

double ReducedSystem::uncut_tension(std::size_t spring) const {
  return uncut_tension_at_rest(spring) + mechanism_.springs[spring].damping * springs_[spring].rate;
}

double ReducedSystem::uncut_tension_at_rest(std::size_t spring) const {
  return uncut_elastic_tension(spring) - spring_forces_[spring];
}

double ReducedSystem::uncut_elastic_tension(std::size_t spring) const {
  Spring both = mechanism_.springs[spring];
  both.acts = SpringSense::both;
  return elastic_tension(both, springs_[spring].position);
}

std::optional<BodyId> ReducedSystem::wrong_rotor() const {
  for (std::size_t b = 0; b < mechanism_.masses.size(); ++b) {
    const std::optional<Vec3>& drawn = mechanism_.masses[b].polar_axis;
    if (!drawn) {
      continue;
    }
    const Vec3 axis = state_.poses[b].rotation * *drawn;
    for (const MotionState& unit : units_) {
      const Vec3& turns = unit.twists[b].angular;
      if (turns.cross(axis).norm() > kOffRotorAxis * std::max(turns.norm(), 1.0)) {
        return BodyId{static_cast<int>(b)};
      }
    }
  }
  return std::nullopt;
}

double ReducedSystem::potential(const MotionState& state) const {
  double sum = 0.0;
  for (const Load& load : which_.loads) {
    if (is_weight(load) && load.point) {
      const Vec3 now = state.poses[at(load.acts.body.value)].point(*load.point);
      sum -= load.acts.wrench.force.dot(now - *load.point);
    }
  }
  for (std::size_t i = 0; i < springs_.size(); ++i) {
    sum += stored_energy(mechanism_.springs[i], springs_[i].position);
  }
  return sum;
}

VecX ReducedSystem::direction_of(int freedom) const {
  VecX result(static_cast<Eigen::Index>(units_.size()));
  for (std::size_t j = 0; j < units_.size(); ++j) {
    result[static_cast<Eigen::Index>(j)] = unit_rate(j, freedom);
  }
  return result;
}

VecX ReducedSystem::direction_of(std::span<const SlidingTerm> slides) const {
  VecX sum = VecX::Zero(static_cast<Eigen::Index>(units_.size()));
  for (const SlidingTerm& term : slides) {
    sum += term.factor * direction_of(term.freedom);
  }
  return sum;
}

std::optional<ReducedSystem::Impulse> ReducedSystem::impulse_at(int freedom) const {
  const auto free = static_cast<Eigen::Index>(free_count_);
  if (free == 0) {
    return std::nullopt;
  }
  const VecX all = direction_of(freedom);
  const auto held = all.size() - free;
  const VecX along = all.head(free);
  const std::optional<VecX> answer = solve_dense(inertia_.topLeftCorner(free, free), along);
  const double mobility = answer ? along.dot(*answer) : 0.0;
  if (!(mobility > 0.0)) {
    return std::nullopt;
  }
  const VecX speeds = *answer / mobility;
  return Impulse{.speeds = speeds,
                 .held = inertia_.bottomLeftCorner(held, free) * speeds - all.tail(held) / mobility,
                 .inertia = 1.0 / mobility};
}

std::optional<double> ReducedSystem::acceleration_of(int freedom,
                                                     const Configuration& configuration,
                                                     std::span<const double> speeds,
                                                     std::span<const double> accelerations) {
  set_speeds(speeds, accelerations);
  const MotionState state = states_.solve(configuration, speeds_, StateDetail::acceleration);
  const auto& rates = state.rate_rates;
  return at(freedom) < rates.size() ? rates[at(freedom)] : std::nullopt;
}

bool ReducedSystem::fail(SimulationObstacle::Kind kind) {
  obstacle_ = {.kind = kind};
  return false;
}

std::vector<std::optional<double>> ReducedSystem::rates(const Configuration& configuration,
                                                        std::span<const double> speeds) {
  set_speeds(speeds, {});
  return states_.solve(configuration, speeds_, StateDetail::velocity).rates;
}

ReducedState ReducedSystem::tell(const Configuration& configuration,
                                 std::span<const double> speeds,
                                 std::span<const double> accelerations,
                                 bool with_actions) {
  ReducedState result;
  set_speeds(speeds, accelerations);
  result.state = states_.solve_bounded(configuration, speeds_, StateDetail::acceleration);
  result.positions = settled_positions(states_, configuration, result.state);
  result.held = held_;
  result.actions = actions_;
  result.friction = friction_;
  result.springs = springs_;
  result.load_powers = load_powers_;
  for (std::size_t i = 0; i < mechanism_.frictions.size(); ++i) {
    const CouplingFriction& friction = mechanism_.frictions[i];
    const int freedom = mechanism_.topology.coupling(friction.coupling).first_freedom;
    const std::optional<double>& rate = result.state.rates[at(freedom)];
    if (friction.viscous != 0.0 && rate && (friction_[i] || !frictions_[i].is_dry())) {
      result.friction[i] = friction_[i].value_or(0.0) - friction.planets * friction.viscous * *rate;
    }
  }
  if (with_actions) {
    balance_->place(configuration, result.state.poses, result.state.bounds.place);
    find_borne(result.state, result);
  }
  result.kinetic = kinetic_of(mechanism_, result.state);
  result.potential = potential(state_);
  return result;
}

std::optional<ReducedState> ReducedSystem::tell_singular(const Configuration& configuration,
                                                         std::span<const double> speeds) {
  if (obstacle_.kind != SimulationObstacle::Kind::singular) {
    return std::nullopt;
  }
  ReducedState result;
  set_speeds(speeds, {});
  result.state = states_.solve_bounded(configuration, speeds_, StateDetail::velocity);
  result.positions = settled_positions(states_, configuration, result.state);
  MotionState& state = result.state;
  if (state.is_singular) {
    state.rates.assign(mechanism_.topology.freedoms.size(), std::nullopt);
    for (std::size_t d = 0; d < speeds.size(); ++d) {
      state.rates[at(network_.driven_freedoms[d])] = speeds[d];
    }
  } else {
    result.kinetic = kinetic_of(mechanism_, state);
  }
  if (!mechanism_.springs.empty()) {
    const std::vector<double> none(mechanism_.springs.size(), 0.0);
    const auto springs = spring_states(
        mechanism_, {.poses = state.poses, .positions = result.positions, .time = {}}, none);
    if (const SpringObstacle* const no_force = std::get_if<SpringObstacle>(&springs)) {
      obstacle_ = {.kind = SimulationObstacle::Kind::spring, .of_spring = *no_force};
      return std::nullopt;
    }
    springs_ = std::get<std::vector<SpringState>>(springs);
  }
  result.potential = potential(state);
  return result;
}

}  // namespace kinestat
