#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "core/index.hpp"
#include "core/simulation_tolerance.hpp"
#include "core/tolerance.hpp"
#include "math/dense/first_crossing.hpp"
#include "studies/motion/configuration.hpp"
#include "studies/simulation/internal/simulator.hpp"

namespace kinestat {

namespace {

// A rebound that is lower than the tolerance times this, in sizes or radians, is none.
constexpr double kNoRebound = 1.0;

// No impact is left after so many at once.
constexpr int kMostImpacts = 1000;

constexpr int kMostHalvings = 200;

// So many stops that are touched at once are tried in all ways.
constexpr std::size_t kMostAtOneTime = 8;

}  // namespace

std::optional<double> Simulator::distance(const Happening& what, double time) {
  std::vector<double> y(state_.size());
  time == integration_->time() ? void(std::ranges::copy(integration_->state(), y.begin()))
                               : integration_->state_at(time, y);
  return distance(what, time, y);
}

std::optional<double> Simulator::distance(const Happening& what,
                                          double time,
                                          std::span<const double> y) {
  if (what.kind == SimulationEvent::Kind::goal) {
    const SimulationGoal& goal = plan_.goals[what.index];
    const std::optional<double> now =
        goal.is_speed ? speed_at(goal.of.freedom, time, y) : position_at(goal.of.freedom, time, y);
    const double sign = signs_[what.index];
    return now ? std::optional((sign == 0.0 ? 1.0 : sign) * (*now - goal.value)) : std::nullopt;
  }
  if (what.kind == SimulationEvent::Kind::stick) {
    const std::optional<double> now = sliding_at(what.index, time, y);
    if (now && senses_[what.index].sense == 0) {
      return kSlidesAgain * fastest_ * unit(freedom_of(what.index)) - std::abs(*now);
    }
    return now ? std::optional(senses_[what.index].sense * *now + no_sliding(what.index))
               : std::nullopt;
  }
  if (what.kind == SimulationEvent::Kind::slip) {
    Configuration there;
    const std::optional<double> gives =
        place(time, y, there) ? breakaway(what.index, what.sense, time, there, y) : std::nullopt;
    return gives ? std::optional(-*gives) : std::nullopt;
  }
  if (what.kind >= SimulationEvent::Kind::cable_slack) {
    return distance_to_parting(what, time, y);
  }
  const SimulationStop& stop = plan_.stops[what.index];
  if (what.kind == SimulationEvent::Kind::impact) {
    const std::optional<double> now = position_at(stop.of.freedom, time, y);
    return now ? std::optional(stop.side * (stop.place - *now)) : std::nullopt;
  }
  Configuration configuration;
  std::vector<double> ignored(free_count());
  if (!place(time, y, configuration) || !accelerate(time, configuration, y, ignored)) {
    return std::nullopt;
  }
  return -stop.side * system_->held_actions()[held_place(what.index)];
}

std::size_t Simulator::held_place(std::size_t stop) const {
  std::size_t place = plan_.held.size();
  for (std::size_t s = 0; s < stop; ++s) {
    place += rests_[s] ? 1U : 0U;
  }
  return place;
}

bool Simulator::is_kept(int freedom) const {
  const VecX along = system_->direction_of(freedom);
  double moves = 0.0;
  for (std::size_t j = 0; j < free_count(); ++j) {
    moves += std::abs(along[static_cast<Eigen::Index>(j)]) * unit_of(j) / unit(freedom);
  }
  for (std::size_t k = 0; k < plan_.held.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(free_count() + k);
    moves += std::abs(along[row] * held_speed(k));
  }
  return !(moves > kIndependentJoint);
}

std::vector<Happening> Simulator::possible() const {
  std::vector<Happening> all = possible_partings();
  for (std::size_t g = 0; g < plan_.goals.size(); ++g) {
    all.push_back({.kind = SimulationEvent::Kind::goal, .index = g});
  }
  for (std::size_t s = 0; s < plan_.stops.size(); ++s) {
    if (!rests_[s] && is_kept(plan_.stops[s].of.freedom)) {
      continue;
    }
    all.push_back(
        {.kind = rests_[s] ? SimulationEvent::Kind::release : SimulationEvent::Kind::impact,
         .index = s});
  }
  for (const std::size_t i : dry_) {
    if (senses_[i].sense != 0 || rests(i)) {
      all.push_back({.kind = SimulationEvent::Kind::stick, .index = i});
    }
  }
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    all.push_back({.kind = SimulationEvent::Kind::slip, .index = g, .sense = 1});
    all.push_back({.kind = SimulationEvent::Kind::slip, .index = g, .sense = -1});
  }
  return all;
}

std::optional<Happening> Simulator::find_first() {
  std::optional<Happening> first;
  const double from = integration_->time_before();
  const double to = std::min(integration_->time(), plan_.duration);
  for (Happening what : possible()) {
    if (what.kind == SimulationEvent::Kind::goal && signs_[what.index] == 0.0) {
      continue;
    }
    const double end = first ? first->time : to;
    const std::optional<SignChange> crossing = find_crossing(
        [&](double time) { return distance(what, time); }, from, end, parts_of(from, end));
    if (crossing) {
      what.time = root(what, crossing->before, crossing->behind);
      if (!first || what.time < first->time) {
        first = what;
      }
    }
  }
  return first;
}

int Simulator::parts_of(double from, double to) {
  constexpr double kLeastParts = 4.0;
  const double wanted = std::ceil((to - from) * watch_.turns() / kFarthestTurn);
  const int parts = static_cast<int>(
      std::clamp(wanted, kLeastParts, std::max(kLeastParts, static_cast<double>(parts_left_))));
  parts_left_ -= parts - static_cast<int>(kLeastParts);
  return parts;
}

double Simulator::root(const Happening& what, double low, double high) {
  double above = std::max(distance(what, low).value_or(0.0), 0.0);
  double below = distance(what, high).value_or(-1.0);
  for (int round = 0; round < kMostHalvings; ++round) {
    if (high - low <= 2.0 * kEpsilon * std::abs(high)) {
      break;
    }
    // By the chord, every third time by halves.
    double next = 0.5 * (low + high);
    if (round % 3 != 2 && above > below) {
      next =
          low + (high - low) * std::clamp(above / (above - below), kLeastChord, 1.0 - kLeastChord);
    }
    const double there = distance(what, next).value_or(-1.0);
    (there < 0.0 ? high : low) = next;
    (there < 0.0 ? below : above) = there;
  }
  return high;
}

void Simulator::note_signs() {
  for (std::size_t g = 0; g < signs_.size(); ++g) {
    if (signs_[g] == 0.0) {
      const SimulationGoal& goal = plan_.goals[g];
      const Happening what{.kind = SimulationEvent::Kind::goal, .index = g};
      const double there = distance(what, time_, state_).value_or(0.0);
      const double rounding = goal.is_speed ? kAtRest * fastest() * unit(goal.of.freedom) : 0.0;
      signs_[g] = there > rounding ? 1.0 : there < -rounding ? -1.0 : 0.0;
    }
  }
}

bool Simulator::meet(const Happening& what) {
  const auto reach = [&](std::size_t goal) {
    note(SimulationEvent::Kind::goal, plan_.goals[goal].of);
    result_.end = SimulationEnd::goal;
  };
  if (what.kind == SimulationEvent::Kind::goal) {
    reach(what.index);
    return true;
  }
  if (what.kind >= SimulationEvent::Kind::cable_slack) {
    end_by(what);
    return true;
  }
  note_signs();
  if (what.kind == SimulationEvent::Kind::stick) {
    return decide_friction(std::nullopt);
  }
  if (what.kind == SimulationEvent::Kind::slip) {
    return decide_friction(what);
  }
  const SimulationStop& stop = plan_.stops[what.index];
  if (what.kind == SimulationEvent::Kind::release) {
    const std::optional<VecX> rates = joint_rates(anchor_, speeds_of(state_));
    note(SimulationEvent::Kind::release, stop.of);
    std::vector<bool> others = rests_;
    others[what.index] = false;
    rests_[what.index] = false;
    return rates && choose_rests(others, *rates) && decide_friction(std::nullopt);
  }
  // An impact passes over speeds, but reaches those that it ends at.
  const std::vector<double> before = signs_;
  for (std::size_t g = 0; g < signs_.size(); ++g) {
    signs_[g] = plan_.goals[g].is_speed ? 0.0 : signs_[g];
  }
  if (!strike(what.index)) {
    return false;
  }
  note_signs();
  for (std::size_t g = 0; g < signs_.size() && result_.end == SimulationEnd::complete; ++g) {
    if (before[g] != 0.0 && signs_[g] == 0.0) {
      reach(g);
    }
  }
  return true;
}

SimulationEvent& Simulator::note(SimulationEvent::Kind kind, const NamedFreedom& of) {
  result_.events.push_back({.kind = kind,
                            .time = time_,
                            .element = of.name,
                            .is_rotation = topology_.freedoms[at(of.freedom)].is_rotation,
                            .position = position_at(of.freedom, time_, state_),
                            .speed = speed_at(of.freedom, time_, state_)});
  return result_.events.back();
}

void Simulator::note_impact(const SimulationStop& stop, double before) {
  SimulationEvent& event = note(SimulationEvent::Kind::impact, stop.of);
  event.speed = before;
  event.speed_after = speed_along(stop.of.freedom);
}

bool Simulator::strike(std::size_t index) {
  std::optional<VecX> rates = joint_rates(anchor_, speeds_of(state_));
  if (!rates) {
    return false;
  }
  const double before = speed_at(plan_.stops[index].of.freedom, time_, state_).value_or(0.0);
  const bool had_rest = std::ranges::count(rests_, true) > 0;
  std::vector<bool> rested = rests_;  // and was not struck since
  std::vector<bool> touched = rests_;
  touched[index] = true;
  if (had_rest || has_dry()) {
    rests_.assign(rests_.size(), false);
    stuck_before_ = std::exchange(groups_, {});
    senses_.assign(senses_.size(), {});
    go_on_with(*rates);
  }
  std::vector<double> ignored(free_count());
  if (!accelerate(time_, anchor_, state_, ignored)) {
    return false;
  }
  const std::size_t free = free_count();
  bool is_new = true;
  for (int round = 0; round < kMostImpacts; ++round) {
    bool is_quiet = true;
    for (std::size_t s = 0; s < touched.size(); ++s) {
      const SimulationStop& stop = plan_.stops[s];
      if (!touched[s]) {
        continue;
      }
      const double into = stop.side * speed_along(stop.of.freedom);
      const double least = s == index && is_new ? 0.0 : kEpsilon * fastest_ * unit(stop.of.freedom);
      const std::optional<ReducedSystem::Impulse> impulse = system_->impulse_at(stop.of.freedom);
      if (!(into > least) || !impulse) {
        continue;
      }
      is_quiet = false;
      const double by = -(1.0 + stop.restitution) * stop.side * into;
      if (parts_by(s, *impulse, by)) {
        return true;
      }
      lost_ += 0.5 * impulse->inertia * into * into * (1.0 - stop.restitution * stop.restitution);
      for (std::size_t j = 0; j < free; ++j) {
        state_[free + j] += by * impulse->speeds[static_cast<Eigen::Index>(j)];
      }
      note_impact(stop, s == index && is_new ? before : stop.side * into);
      rested[s] = false;
      is_new = is_new && s != index;
      for (Eigen::Index k = 0; k < impulse->held.size(); ++k) {
        supplied_ += by * impulse->held[k] * held_speed(static_cast<std::size_t>(k));
      }
    }
    if (is_quiet) {
      break;
    }
  }
  state_[2 * free] = supplied_;
  state_[2 * free + 1] = lost_;
  if (is_new) {
    note_impact(plan_.stops[index], before);
  }
  return settle(touched, rested);
}

bool Simulator::settle(const std::vector<bool>& touched, const std::vector<bool>& rested) {
  std::optional<VecX> rates = joint_rates(anchor_, speeds_of(state_));
  if (!rates) {
    return false;
  }
  double flight = std::numeric_limits<double>::infinity();
  std::vector<double> accelerations(free_count());
  if (!accelerate(time_, anchor_, state_, accelerations)) {
    return false;
  }
  if (has_dry()) {
    read_senses();
    if (!accelerate(time_, anchor_, state_, accelerations)) {
      return false;
    }
  }
  std::vector<bool> candidates(touched.size(), false);
  std::vector<double> series(touched.size(), 0.0);  // until all that would follow is over
  std::vector<double> left(touched.size(), 0.0);    // energy of that
  for (std::size_t s = 0; s < touched.size(); ++s) {
    const SimulationStop& stop = plan_.stops[s];
    const int freedom = stop.of.freedom;
    const std::optional<double> found =
        system_->acceleration_of(freedom, anchor_, speeds_of(state_), accelerations);
    if (!touched[s] || !found) {
      continue;
    }
    const double leaves = -stop.side * speed_along(freedom);
    const double presses = stop.side * *found;
    const bool stays = std::abs(leaves) <= kEpsilon * fastest_ * unit(stop.of.freedom);
    if (!stays && !(presses > 0.0)) {
      continue;
    }
    const double height = stays ? 0.0 : 0.5 * leaves * leaves / presses;
    candidates[s] = height <= kNoRebound * plan_.tolerance * unit(stop.of.freedom);
    if (!candidates[s]) {
      flight = std::min(flight, 2.0 * leaves / presses);
      continue;
    }
    const bool hops = leaves > 0.0 && !stays;
    series[s] = hops ? 2.0 * leaves / (presses * (1.0 - stop.restitution)) : 0.0;
    const auto impulse = system_->impulse_at(freedom);
    left[s] = impulse ? 0.5 * impulse->inertia * leaves * leaves : 0.0;
  }
  if (!choose_rests(candidates, *rates)) {
    return false;
  }
  for (std::size_t s = 0; s < touched.size(); ++s) {
    if (rests_[s] && !rested[s]) {
      note(SimulationEvent::Kind::rest, plan_.stops[s].of).time += series[s];
      result_.events.back().speed = 0.0;
      lost_ += left[s];
    }
  }
  state_[2 * free_count() + 1] = lost_;
  if (!decide_friction(std::nullopt)) {
    return false;
  }
  step_ = std::min(step_.value_or(flight), 0.2 * flight);
  restart();
  return true;
}

// Which of the stops that are touched bear something: those push, and what is at the others leaves
// them or stays by itself. All ways are tried, with most that rest first.
bool Simulator::choose_rests(const std::vector<bool>& candidates, const VecX& rates) {
  std::vector<std::size_t> all;
  for (std::size_t s = 0; s < candidates.size(); ++s) {
    if (candidates[s]) {
      all.push_back(s);
    }
  }
  if (all.size() > kMostAtOneTime) {
    obstacle_ = {.kind = SimulationObstacle::Kind::no_progress};
    return false;
  }
  const std::size_t count = std::size_t{1} << all.size();
  for (std::size_t way = count; way-- > 0;) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      rests_[all[i]] = ((way >> i) & 1U) != 0U;
    }
    if (bears(all, rates)) {
      return true;
    }
  }
  obstacle_ = {.kind = SimulationObstacle::Kind::no_progress};
  return false;
}

bool Simulator::bears(const std::vector<std::size_t>& touched, const VecX& rates) {
  const std::vector<int> held = held_rates();
  const std::vector<int> kept =
      independent_rates(network_, JointFollower(network_).free_motions(anchor_), held);
  if (kept.size() < held.size() || !std::equal(held.begin(), held.end(), kept.begin())) {
    return false;
  }
  go_on_with(rates);
  std::vector<double> accelerations(free_count());
  if (!accelerate(time_, anchor_, state_, accelerations)) {
    return false;
  }
  return std::ranges::all_of(touched, [&](std::size_t s) {
    const SimulationStop& stop = plan_.stops[s];
    if (rests_[s]) {
      return -stop.side * system_->held_actions()[held_place(s)] >= 0.0;
    }
    const std::optional<double> found =
        system_->acceleration_of(stop.of.freedom, anchor_, speeds_of(state_), accelerations);
    return found && stop.side * *found <= 0.0;
  });
}

bool Simulator::begin_contacts() {
  note_signs();
  std::vector<bool> touched(plan_.stops.size(), false);
  for (std::size_t s = 0; s < touched.size(); ++s) {
    const SimulationStop& stop = plan_.stops[s];
    const std::optional<double> now = position_at(stop.of.freedom, time_, state_);
    touched[s] = now && std::abs(*now - stop.place) <= kAtStop * unit(stop.of.freedom);
    if (now && !touched[s] && stop.side * (stop.place - *now) < 0.0) {
      obstacle_ = {.kind = SimulationObstacle::Kind::beyond_stop};
      return false;
    }
  }
  if (std::ranges::count(touched, true) == 0) {
    return decide_friction(std::nullopt);
  }
  for (std::size_t s = 0; s < touched.size(); ++s) {
    const std::optional<double> speed = speed_at(plan_.stops[s].of.freedom, time_, state_);
    if (touched[s] && speed && plan_.stops[s].side * *speed > 0.0) {
      return meet({.kind = SimulationEvent::Kind::impact, .index = s, .time = time_});
    }
  }
  return settle(touched, std::vector<bool>(touched.size(), false));
}

}  // namespace kinestat
