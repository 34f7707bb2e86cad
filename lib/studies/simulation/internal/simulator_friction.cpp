// Couplings that stick and slip.
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>

#include "core/index.hpp"
#include "core/simulation_tolerance.hpp"
#include "studies/simulation/internal/simulator.hpp"

namespace kinestat {

namespace {

// So many groups that come to rest at one time are tried in all ways.
constexpr std::size_t kMostGroups = 5;

// All ways in which groups stick (0) or slide, those with most that stick first.
std::vector<std::vector<int>> patterns_of(std::size_t groups) {
  std::vector<std::vector<int>> all = {{}};
  for (std::size_t g = 0; g < groups; ++g) {
    std::vector<std::vector<int>> longer;
    for (const std::vector<int>& one : all) {
      for (const int sense : {0, 1, -1}) {
        longer.push_back(one);
        longer.back().push_back(sense);
      }
    }
    all = std::move(longer);
  }
  std::ranges::stable_sort(
      all, std::greater(), [](const std::vector<int>& one) { return std::ranges::count(one, 0); });
  return all;
}

bool are_independent(std::vector<VecX> directions) {
  for (std::size_t i = 0; i < directions.size(); ++i) {
    if (!(directions[i].norm() > kIndependentJoint)) {
      return false;
    }
    directions[i].normalize();
    for (std::size_t k = i + 1; k < directions.size(); ++k) {
      directions[k] -= directions[i].dot(directions[k]) * directions[i];
    }
  }
  return true;
}

// Whether there is a motion for each group that sticks, so that it is known what holds each.
bool stick_alone(const std::vector<int>& pattern, const std::vector<VecX>& directions) {
  std::vector<VecX> sticking;
  for (std::size_t g = 0; g < pattern.size(); ++g) {
    if (pattern[g] == 0) {
      sticking.push_back(directions[g]);
    }
  }
  return are_independent(std::move(sticking));
}

// How it speeds up.
std::optional<double> sliding_acceleration(const Rubbing& friction,
                                           ReducedSystem& system,
                                           const Configuration& configuration,
                                           std::span<const double> speeds,
                                           std::span<const double> accelerations) {
  double sum = 0.0;
  for (const SlidingTerm& term : friction.slides) {
    const std::optional<double> one =
        system.acceleration_of(term.freedom, configuration, speeds, accelerations);
    if (!one) {
      return std::nullopt;
    }
    sum += term.factor * *one;
  }
  return sum;
}

}  // namespace

bool Simulator::rests(std::size_t friction) const {
  return senses_[friction].sense == 0 && std::ranges::none_of(groups_, [&](const StuckGroup& one) {
           return std::ranges::count(one.frictions, friction) > 0;
         });
}

bool Simulator::is_joint(std::size_t friction) const {
  return frictions_[friction].slides.size() == 1 &&
         rate_of_freedom(network_, freedom_of(friction)) >= 0;
}

double Simulator::no_sliding(std::size_t friction) const {
  return kNoSliding * fastest_ * unit(freedom_of(friction));
}

void Simulator::read_senses() {
  senses_.assign(senses_.size(), {});
  const double most = fastest();
  for (const std::size_t i : dry_) {
    double speed = 0.0;
    for (const SlidingTerm& term : frictions_[i].slides) {
      speed += term.factor * speed_along(term.freedom);
    }
    if (std::abs(speed) > kAtRest * most * unit(freedom_of(i))) {
      senses_[i].sense = speed > 0.0 ? 1 : -1;
    }
  }
  system_->set_friction(senses_, false);
}

std::vector<VecX> Simulator::directions_of(const std::vector<StuckGroup>& groups) const {
  std::vector<VecX> directions;
  for (const StuckGroup& group : groups) {
    directions.push_back(direction_in_sizes(group.frictions.front()));
  }
  return directions;
}

VecX Simulator::direction_in_sizes(std::size_t friction) const {
  const auto free = static_cast<Eigen::Index>(free_count());
  VecX direction =
      system_->direction_of(frictions_[friction].slides).head(free) / unit(freedom_of(friction));
  for (Eigen::Index j = 0; j < free; ++j) {
    direction[j] *= unit_of(static_cast<std::size_t>(j));
  }
  return direction;
}

// Its direction among those that do not slide. A pulley that only cables hold, each unless it
// slips, counts with the cables that stick: by what is left of its direction without their slip.
VecX Simulator::direction_at_rest(std::size_t friction) const {
  VecX direction = direction_in_sizes(friction);
  if (!frictions_[friction].is_of_gripped()) {
    return direction;
  }
  std::vector<VecX> slips;
  for (const std::size_t i : dry_) {
    if (senses_[i].sense != 0 || !frictions_[i].is_slip()) {
      continue;
    }
    VecX slip = direction_in_sizes(i);
    for (const VecX& other : slips) {
      slip -= other.dot(slip) * other;
    }
    if (slip.norm() > kIndependentJoint) {
      slips.push_back(slip.normalized());
      direction -= slips.back().dot(direction) * slips.back();
    }
  }
  return direction;
}

// Of frictions that do not slide those that could, by what moves them; the first of each is a joint
// of the tree where one is. What nothing moves rests by other means.
std::vector<Simulator::StuckGroup> Simulator::groups_at_rest() const {
  std::vector<StuckGroup> groups;
  std::vector<VecX> directions;
  for (const std::size_t i : dry_) {
    VecX direction = direction_at_rest(i);
    if (senses_[i].sense != 0 || !(direction.norm() > kIndependentJoint)) {
      continue;
    }
    direction.normalize();
    std::size_t g = 0;
    while (g < groups.size() &&
           (direction - directions[g].dot(direction) * directions[g]).norm() > kIndependentJoint) {
      ++g;
    }
    if (g == groups.size()) {
      groups.emplace_back();
      directions.push_back(direction);
    }
    StuckGroup& group = groups[g];
    const int sense = directions[g].dot(direction) > 0.0 ? 1 : -1;
    if (group.frictions.empty() || !is_joint(i) || is_joint(group.frictions.front())) {
      group.frictions.push_back(i);
      group.senses.push_back(sense);
      continue;
    }
    group.frictions.insert(group.frictions.begin(), i);
    group.senses.insert(group.senses.begin(), sense);
    directions[g] = direction;
    for (int& one : group.senses) {
      one *= sense;
    }
  }
  return groups;
}

// Why these cannot be followed, if so: of what would stick without being a joint of the tree its
// sliding tells whether it does, unless it may do both.
std::optional<SimulationObstacle> Simulator::obstacle_of(
    const std::vector<StuckGroup>& groups) const {
  for (const StuckGroup& group : groups) {
    const std::size_t lead = group.frictions.front();
    const bool has_both = std::ranges::any_of(
        group.frictions, [&](std::size_t i) { return frictions_[i].has_more_at_rest(); });
    if (has_both && !is_joint(lead)) {
      return SimulationObstacle{.kind = SimulationObstacle::Kind::stuck_in_circuit,
                                .coupling = frictions_[lead].coupling};
    }
  }
  if (groups.size() > kMostGroups) {
    return SimulationObstacle{.kind = SimulationObstacle::Kind::open_friction,
                              .coupling = frictions_[groups.front().frictions.front()].coupling};
  }
  return std::nullopt;
}

void Simulator::take(const std::vector<StuckGroup>& groups, const std::vector<int>& pattern) {
  groups_.clear();
  for (std::size_t g = 0; g < groups.size(); ++g) {
    for (std::size_t i = 0; i < groups[g].frictions.size(); ++i) {
      senses_[groups[g].frictions[i]] = {.sense = pattern[g] * groups[g].senses[i]};
    }
    if (pattern[g] == 0) {
      groups_.push_back(groups[g]);
    }
  }
}

bool Simulator::is_consistent(const std::vector<StuckGroup>& groups,
                              const std::vector<int>& pattern,
                              const VecX& rates,
                              std::optional<std::size_t> given) {
  take(groups, pattern);
  go_on_with(rates);
  std::vector<double> accelerations(free_count());
  if (!accelerate(time_, anchor_, state_, accelerations)) {
    return false;
  }
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (pattern[g] == 0 || g == given) {
      continue;
    }
    const std::optional<double> leaves =
        sliding_acceleration(frictions_[groups[g].frictions.front()],
                             *system_,
                             anchor_,
                             speeds_of(state_),
                             accelerations);
    if (!leaves || !(pattern[g] * *leaves > 0.0)) {
      return false;
    }
  }
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    for (const int sense : {1, -1}) {
      const std::optional<double> gives = breakaway(g, sense, time_, anchor_, state_);
      if (gives && *gives > 0.0) {
        return false;
      }
    }
  }
  return true;
}

std::optional<std::vector<int>> Simulator::find_pattern(const std::vector<StuckGroup>& groups,
                                                        const VecX& rates,
                                                        std::optional<std::size_t> forced,
                                                        int sense) {
  const std::vector<FrictionSense> sliding = senses_;
  const SimulationObstacle in_two_ways{
      .kind = SimulationObstacle::Kind::friction_in_two_ways,
      .coupling = frictions_[groups.front().frictions.front()].coupling};
  const std::vector<VecX> directions = directions_of(groups);
  std::optional<SimulationObstacle> why;
  std::optional<std::vector<int>> found;
  for (const std::vector<int>& pattern : patterns_of(groups.size())) {
    bool is_left_out = forced && pattern[*forced] != sense;
    for (std::size_t g = 0; g < groups.size() && !is_left_out; ++g) {
      const std::size_t lead = groups[g].frictions.front();
      if (pattern[g] == 0 && !is_joint(lead)) {
        is_left_out = true;
        why = SimulationObstacle{.kind = SimulationObstacle::Kind::stuck_in_circuit,
                                 .coupling = frictions_[lead].coupling};
      }
    }
    if (!is_left_out && !stick_alone(pattern, directions)) {
      is_left_out = true;
      why = why.value_or(SimulationObstacle{.kind = SimulationObstacle::Kind::open_friction,
                                            .coupling = in_two_ways.coupling});
    }
    if (is_left_out || (found && std::ranges::count(pattern, 0) < std::ranges::count(*found, 0))) {
      continue;
    }
    senses_ = sliding;
    obstacle_ = in_two_ways;
    if (!is_consistent(groups, pattern, rates, forced)) {
      const bool has_reason = obstacle_.kind != in_two_ways.kind;
      why = has_reason ? why.value_or(obstacle_) : why;
    } else if (found) {
      obstacle_ = in_two_ways;
      return std::nullopt;
    } else {
      found = pattern;
    }
  }
  senses_ = sliding;
  obstacle_ = why.value_or(in_two_ways);
  return found;
}

// Where more groups stick than there are motions, how they share is open, but not whether they
// hold: they do if some of them do it alone, one for each motion. What gives way is not among
// these.
bool Simulator::stick_together(const std::vector<StuckGroup>& groups,
                               const VecX& rates,
                               std::optional<std::size_t> gives_way) {
  std::size_t most = 0;
  std::vector<std::vector<std::size_t>> all;
  for (std::size_t mask = 1; mask < std::size_t{1} << groups.size(); ++mask) {
    std::vector<std::size_t> chosen;
    std::vector<VecX> directions;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      if ((mask >> g & 1U) != 0) {
        chosen.push_back(g);
        directions.push_back(direction_in_sizes(groups[g].frictions.front()));
      }
    }
    if (are_independent(std::move(directions))) {
      most = std::max(most, chosen.size());
      all.push_back(std::move(chosen));
    }
  }
  for (const std::vector<std::size_t>& chosen : all) {
    const bool is_led = std::ranges::all_of(chosen, [&](std::size_t g) {
      return g != gives_way && is_joint(groups[g].frictions.front());
    });
    if (chosen.size() < most || !is_led) {
      continue;
    }
    std::vector<StuckGroup> sticking;
    for (const std::size_t g : chosen) {
      StuckGroup one = groups[g];
      for (std::size_t other = 0; other < groups.size(); ++other) {
        if (std::ranges::find(chosen, other) == chosen.end()) {
          one.frictions.insert(
              one.frictions.end(), groups[other].frictions.begin(), groups[other].frictions.end());
          one.senses.resize(one.frictions.size(), 0);
        }
      }
      sticking.push_back(std::move(one));
    }
    if (is_consistent(sticking, std::vector<int>(sticking.size(), 0), rates, {})) {
      return true;
    }
  }
  return false;
}

bool Simulator::decide_friction(const std::optional<Happening>& given) {
  if (!has_dry()) {
    return true;
  }
  const std::optional<VecX> rates = joint_rates(anchor_, speeds_of(state_));
  if (!rates) {
    return false;
  }
  std::vector<StuckGroup> before = std::exchange(groups_, {});
  std::ranges::move(std::exchange(stuck_before_, {}), std::back_inserter(before));
  senses_.assign(senses_.size(), {});
  go_on_with(*rates);
  std::vector<double> ignored(free_count());
  if (!accelerate(time_, anchor_, state_, ignored)) {
    return false;
  }
  read_senses();
  const std::vector<StuckGroup> groups = groups_at_rest();
  if (groups.empty()) {
    restart();
    tell_changes(before);
    return accelerate(time_, anchor_, state_, ignored);
  }
  std::optional<std::size_t> forced;
  for (std::size_t g = 0; g < groups.size() && given; ++g) {
    const std::size_t lead = before[given->index].frictions.front();
    forced = std::ranges::count(groups[g].frictions, lead) > 0 ? std::optional(g) : forced;
  }
  if (const std::optional<SimulationObstacle> why = obstacle_of(groups)) {
    obstacle_ = *why;
    return false;
  }
  if (!stick_alone(std::vector<int>(groups.size(), 0), directions_of(groups))) {
    const std::vector<FrictionSense> sliding = senses_;
    if (stick_together(groups, *rates, forced)) {
      tell_changes(before);
      return true;
    }
    groups_.clear();
    senses_ = sliding;
    go_on_with(*rates);
  }
  const std::optional<std::vector<int>> found =
      find_pattern(groups, *rates, forced, given ? given->sense : 0);
  if (!found) {
    return false;
  }
  take(groups, *found);
  go_on_with(*rates);
  tell_changes(before);
  return true;
}

// What sticks now, and what slides that did not.
void Simulator::tell_changes(const std::vector<StuckGroup>& before) {
  const auto is_in = [](const std::vector<StuckGroup>& groups, std::size_t friction) {
    return std::ranges::any_of(groups, [&](const StuckGroup& one) {
      return std::ranges::count(one.frictions, friction) > 0;
    });
  };
  const auto tell = [&](SimulationEvent::Kind kind, std::size_t friction) {
    const int freedom = freedom_of(friction);
    note(kind, {.freedom = freedom, .name = topology_.freedom_name(freedom), .where = {}});
    result_.events.back().speed = 0.0;
  };
  for (const StuckGroup& one : before) {
    const std::size_t lead = one.frictions.front();
    if (senses_[lead].sense != 0) {
      tell(SimulationEvent::Kind::slip, lead);
    }
  }
  for (const StuckGroup& one : groups_) {
    if (!is_in(before, one.frictions.front())) {
      tell(SimulationEvent::Kind::stick, one.frictions.front());
    }
  }
}

std::optional<double> Simulator::breakaway(std::size_t group,
                                           int sense,
                                           double time,
                                           const Configuration& configuration,
                                           std::span<const double> y) {
  const StuckGroup& one = groups_[group];
  ReducedSystem& trial = *trials_[group];
  std::vector<FrictionSense> senses = senses_;
  for (std::size_t i = 0; i < one.frictions.size(); ++i) {
    senses[one.frictions[i]] = {.sense = sense * one.senses[i], .at_rest = true};
  }
  trial.set_friction(std::move(senses), false);
  const std::optional<VecX> rates = joint_rates(configuration, speeds_of(y));
  if (!rates) {
    return std::nullopt;
  }
  std::vector<double> speeds;
  const std::vector<int>& driven = trial.network().driven_rates;
  for (std::size_t d = 0; d < driven.size(); ++d) {
    speeds.push_back((*rates)[driven[d]] * unit_of_rate(trial.network().driven_freedoms[d]));
  }
  std::vector<double> accelerations(trial.free_count());
  ++evaluations_;
  if (!trial.accelerate(time, configuration, speeds, accelerations)) {
    // Where friction has no end it jams.
    if (trial.obstacle().kind == SimulationObstacle::Kind::friction_without_end) {
      return std::nullopt;
    }
    obstacle_ = trial.obstacle();
    return std::numeric_limits<double>::infinity();
  }
  const std::optional<double> found = sliding_acceleration(
      frictions_[one.frictions.front()], trial, configuration, speeds, accelerations);
  return found ? std::optional(sense * *found) : std::nullopt;
}

}  // namespace kinestat
