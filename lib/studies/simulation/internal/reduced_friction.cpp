// Dry friction in the reduced equation, and what couplings bear.
#include <algorithm>
#include <iterator>
#include <utility>

#include "core/index.hpp"
#include "dynamics/body_inertia.hpp"
#include "math/dense/dense_solve.hpp"
#include "studies/simulation/reduced_system.hpp"

namespace kinestat {

namespace {

// Of all that acts, friction of these magnitudes and what it causes among it.
std::vector<BodyWrench> with_friction(const std::vector<ActingFriction>& acting,
                                      const VecX& magnitudes,
                                      const StateBalance& balance,
                                      std::vector<BodyWrench> loads) {
  for (std::size_t i = 0; i < acting.size(); ++i) {
    const double size = magnitudes[static_cast<Eigen::Index>(i)];
    const BodyPair bodies = balance.rubbed_bodies(acting[i].law);
    loads.push_back({.body = bodies.head, .wrench = size * acting[i].law.unit});
    loads.push_back({.body = bodies.tail, .wrench = -size * acting[i].law.unit});
    for (const BodyWrench& one : acting[i].along) {
      loads.push_back({.body = one.body, .wrench = size * one.wrench});
    }
  }
  return loads;
}

}  // namespace

// What the inertia of the free coordinates asks of a held one.
double ReducedSystem::held_by_inertia(const VecX& accelerations, std::size_t k) const {
  const auto free = static_cast<Eigen::Index>(free_count_);
  const Eigen::Index row = free + static_cast<Eigen::Index>(k);
  return free > 0 ? inertia_.row(row).head(free).dot(accelerations) : 0.0;
}

// What holds the coordinates without dry friction.
std::vector<double> ReducedSystem::held_with(const VecX& accelerations) const {
  std::vector<double> held;
  for (std::size_t k = 0; k < held_.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(free_count_ + k);
    held.push_back(held_by_inertia(accelerations, k) + bias_[row] - forces_[row]);
  }
  return held;
}

// Beside that of steady coordinates.
std::vector<BodyWrench> ReducedSystem::inertial(const VecX& accelerations) const {
  std::vector<BodyWrench> loads;
  for (std::size_t b = 0; b < carried_.size(); ++b) {
    if (!mechanism_.masses[b].counts()) {
      continue;
    }
    Wrench sum;
    for (Eigen::Index j = 0; j < accelerations.size(); ++j) {
      sum = sum + -accelerations[j] * carried_[b][static_cast<std::size_t>(j)];
    }
    loads.push_back({.body = BodyId{static_cast<int>(b)}, .wrench = sum});
  }
  return loads;
}

void ReducedSystem::add_held(std::span<const double> held, std::vector<BodyWrench>& loads) const {
  for (std::size_t k = 0; k < held.size(); ++k) {
    balance_->add_pair(network_.driven_freedoms[free_count_ + k], held[k], loads);
  }
}

// What is tried for whether it would slides only if it does.
bool ReducedSystem::slides(CouplingId id) const {
  const auto found = std::ranges::find(frictions_, id, &Rubbing::coupling);
  if (found == frictions_.end()) {
    return false;
  }
  const FrictionSense& one = senses_[static_cast<std::size_t>(found - frictions_.begin())];
  return one.sense != 0 && !one.at_rest;
}

std::optional<ActingFriction> ReducedSystem::acting_friction(std::size_t i) {
  const auto free = static_cast<Eigen::Index>(free_count_);
  const CouplingId id = frictions_[i].coupling;
  const int sense = senses_[i].sense;
  double rate = 0.0;
  for (const SlidingTerm& term : frictions_[i].slides) {
    rate += term.factor * state_.rates[at(term.freedom)].value_or(0.0);
  }
  ActingFriction one{
      .index = i,
      .law = balance_->law_of(
          i, sense, rate, senses_[i].at_rest, [this](CouplingId link) { return slides(link); }),
      .rate = sense * rate,
      .work = -sense * direction_of(frictions_[i].slides)};
  if (!one.law.has_value) {
    obstacle_ = {.kind = frictions_[i].gear ? SimulationObstacle::Kind::no_loss
                                            : SimulationObstacle::Kind::open_friction,
                 .coupling = id};
    return std::nullopt;
  }
  if (free > 0) {
    const std::optional<VecX> answer =
        solve_dense(inertia_.topLeftCorner(free, free), VecX(one.work.head(free)));
    if (!answer) {
      obstacle_ = {.kind = SimulationObstacle::Kind::no_inertia};
      return std::nullopt;
    }
    one.answer = *answer;
  }
  one.along = inertial(one.answer);
  std::vector<double> held;
  for (std::size_t k = 0; k < held_.size(); ++k) {
    held.push_back(held_by_inertia(one.answer, k) -
                   one.work[static_cast<Eigen::Index>(free_count_ + k)]);
  }
  add_held(held, one.along);
  return one;
}

std::optional<std::vector<ActingFriction>> ReducedSystem::acting_frictions() {
  std::vector<ActingFriction> acting;
  for (std::size_t i = 0; i < senses_.size(); ++i) {
    if (senses_[i].sense == 0) {
      continue;
    }
    std::optional<ActingFriction> one = acting_friction(i);
    if (!one) {
      return std::nullopt;
    }
    acting.push_back(*std::move(one));
  }
  return acting;
}

// Of each its magnitude; empty where they have none.
std::optional<VecX> ReducedSystem::friction_magnitudes(const std::vector<ActingFriction>& acting,
                                                       std::span<const BodyWrench> loads) {
  std::vector<FrictionLaw> laws;
  std::vector<std::vector<BodyWrench>> with_each;
  for (const ActingFriction& one : acting) {
    laws.push_back(one.law);
    with_each.push_back(one.along);
  }
  const auto presses = [](const FrictionLaw& law) { return !law.parts.empty(); };
  if (is_open_ && std::ranges::any_of(laws, presses)) {
    fail(SimulationObstacle::Kind::open_friction);
    return std::nullopt;
  }
  FrictionMagnitudes found = balance_->solve_friction(loads, laws, with_each);
  using enum FrictionOutcome;
  if (found.outcome != solved) {
    obstacle_ = {.kind = found.outcome == none      ? SimulationObstacle::Kind::friction_without_end
                         : found.outcome == several ? SimulationObstacle::Kind::friction_in_two_ways
                                                    : SimulationObstacle::Kind::open_friction,
                 .coupling = found.open.value_or(laws.front().coupling)};
    return std::nullopt;
  }
  return std::move(found.values);
}

bool ReducedSystem::add_friction(VecX& accelerations) {
  friction_.assign(friction_.size(), std::nullopt);
  std::optional<std::vector<ActingFriction>> acting = acting_frictions();
  if (!acting || acting->empty()) {
    return acting.has_value();
  }
  std::vector<BodyWrench> loads = loads_;
  for (std::size_t b = 0; b < inertial_.size(); ++b) {
    if (mechanism_.masses[b].counts()) {
      loads.push_back({.body = BodyId{static_cast<int>(b)}, .wrench = inertial_[b]});
    }
  }
  std::ranges::copy(inertial(accelerations), std::back_inserter(loads));
  add_held(held_with(accelerations), loads);
  std::optional<VecX> magnitudes = friction_magnitudes(*acting, loads);
  const std::size_t most_rounds = 2 * mechanism_.geometry.other_flanks.size();
  for (std::size_t i = 0;
       magnitudes && balance_->turn_flanks(with_friction(*acting, *magnitudes, *balance_, loads));
       ++i) {
    if (i >= most_rounds) {
      return fail(SimulationObstacle::Kind::friction_without_end);
    }
    acting = acting_frictions();
    magnitudes = acting ? friction_magnitudes(*acting, loads) : std::nullopt;
  }
  if (!magnitudes) {
    return false;
  }
  for (std::size_t i = 0; i < acting->size(); ++i) {
    const ActingFriction& one = (*acting)[i];
    const double size = (*magnitudes)[static_cast<Eigen::Index>(i)];
    const BodyPair bodies = balance_->rubbed_bodies(one.law);
    forces_ += size * one.work;
    sizes_ += size * one.work.cwiseAbs();
    accelerations += size * one.answer;
    friction_[one.index] = -senses_[one.index].sense * size;
    rubbing_.push_back({.body = bodies.head, .wrench = size * one.law.unit});
    rubbing_.push_back({.body = bodies.tail, .wrench = -size * one.law.unit});
    powers_.lost += size * one.rate;
  }
  return true;
}

// Forces of inertia as of a row of a motion, by the accelerations with their bounds.
void ReducedSystem::find_borne(const MotionState& state, ReducedState& told) {
  told.borne.assign(mechanism_.topology.actions.size(), std::nullopt);
  if (is_open_ || state.twist_rates.empty()) {
    return;
  }
  std::vector<BodyWrench> loads = loads_;
  std::ranges::copy(rubbing_, std::back_inserter(loads));
  add_held(held_, loads);
  for (std::size_t b = 0; b < mechanism_.masses.size(); ++b) {
    if (mechanism_.masses[b].counts()) {
      const BodyInertia body = inertia_at(mechanism_.masses[b], state.poses[b]);
      loads.push_back(
          {.body = BodyId{static_cast<int>(b)},
           .wrench = settled(
               inertial_wrench(body, state.twists[b], state.twist_rates[b], state.bounds.bodies[b]),
               body,
               state.bounds)});
    }
  }
  told.borne = balance_->solve(loads);
}

std::vector<std::optional<double>> ReducedSystem::borne_in(const Impulse& impulse,
                                                           int freedom,
                                                           double change) {
  std::vector<BodyWrench> loads = inertial(change * impulse.speeds);
  std::vector<double> held;
  for (const double one : impulse.held) {
    held.push_back(change * one);
  }
  add_held(held, loads);
  balance_->add_pair(freedom, change * impulse.inertia, loads);
  return balance_->solve(loads);
}

}  // namespace kinestat
