#include "studies/simulation/internal/simulator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "core/extreme_tolerance.hpp"
#include "core/index.hpp"
#include "core/simulation_tolerance.hpp"
#include "core/tolerance.hpp"
#include "studies/motion/configuration.hpp"
#include "studies/motion/contact_rates.hpp"

namespace kinestat {

namespace {

// Coordinates are changed where others tell the free motions apart by so many times more.
constexpr double kBetterCoordinates = 10.0;

// Where something may happen between steps, there are so many of them at least.
constexpr int kLeastWatched = 100;

// A step in which more turns [rad] has more to be looked at than it is worth, as long as there are
// not too many of them.
constexpr double kFarthestStep = 16.0;

// So many events at one time, and in all, are too many, and so many accelerations: they take half a
// minute.
constexpr int kMostAtOnce = 1000;
constexpr int kMostEvaluations = 2'000'000;
constexpr std::size_t kMostEvents = 100'000;

// No more points of curves are sought.
constexpr std::size_t kMostTurns = 100'000;

}  // namespace

Simulator::Simulator(const Mechanism& mechanism,
                     const MotionNetwork& network,
                     std::span<const DrawnCoupling> drawn,
                     const SimulationPlan& plan)
    : StateInTime(mechanism, network, drawn, plan), watch_(mechanism, plan) {
  find_turns();
  signs_.resize(plan.goals.size(), 0.0);
  for (std::size_t i = 0; i < mechanism.springs.size(); ++i) {
    if (mechanism.springs[i].acts != SpringSense::both) {
      one_sided_springs_.push_back(i);
    }
  }
}

// Times at which a curve over time has a point.
void Simulator::find_turns() {
  for (const Curve& curve : mechanism_.curves) {
    if (curve.over != Curve::Over::time) {
      continue;
    }
    for (const double place : curve.at) {
      double round = curve.period ? std::ceil(-place / *curve.period) : 0.0;
      double time = place;
      do {
        time = curve.period ? place + round * *curve.period : place;
        if (time > 0.0 && time < plan_.duration) {
          turns_.push_back(time);
        }
        ++round;
      } while (curve.period && time < plan_.duration && turns_.size() < kMostTurns);
    }
  }
  std::ranges::sort(turns_);
}

SimulationSolution Simulator::run(const Configuration& start,
                                  const std::vector<int>& coordinates,
                                  const VecX& rates) {
  anchor_ = start;
  choose_coordinates(coordinates);
  result_.coordinates = std::vector<int>(
      system_->network().driven_freedoms.begin(),
      system_->network().driven_freedoms.begin() + static_cast<std::ptrdiff_t>(free_count()));
  begin_at(0.0, rates);
  if (!begin_contacts()) {
    return stuck();
  }
  while (result_.end == SimulationEnd::complete && plan_.duration - time_ > least_step()) {
    const double before = time_;
    const std::size_t told = result_.events.size();
    if (!advance()) {
      return stuck();
    }
    if (!makes_progress(before, told)) {
      return stuck();
    }
  }
  return finish();
}

double Simulator::least_step() const {
  constexpr double kLeast = 64.0 * kEpsilon;
  return kLeast * plan_.duration;
}

bool Simulator::makes_progress(double before, std::size_t told) {
  if (time_ - before > least_step()) {
    standstill_ = 0;
  } else if (standstill_++ == 0) {
    told_before_ = told;
  }
  if (standstill_ > kMostAtOnce) {
    result_.events.resize(std::min(result_.events.size(), told_before_ + 1));
    obstacle_ = {.kind = SimulationObstacle::Kind::no_progress};
    return false;
  }
  if (evaluations_ > kMostEvaluations || result_.events.size() > kMostEvents) {
    obstacle_ = {.kind = SimulationObstacle::Kind::too_many_steps};
    return false;
  }
  return true;
}

double Simulator::next_turn() const {
  const auto turn = std::ranges::upper_bound(turns_, time_ + least_step());
  constexpr double kNone = std::numeric_limits<double>::infinity();
  return std::min(turn == turns_.end() ? kNone : *turn, turn_.value_or(kNone));
}

// What begins or ends at a time is seen by the steps before and behind it; where something might
// happen unseen there are no long ones.
double Simulator::next_end() const {
  const bool is_watched = !plan_.stops.empty() || !plan_.goals.empty() ||
                          !mechanism_.curves.empty() || has_dry() || !one_sided_.empty() ||
                          !one_sided_springs_.empty();
  const double end = std::min(plan_.duration, next_turn());
  const double step = plan_.duration / std::max(plan_.steps, kLeastWatched);
  const double watched =
      time_ + (parts_left_ > 0 ? std::min(step, kFarthestStep / watch_.turns()) : step);
  return is_watched && watched < end - least_step() ? watched : end;
}

bool Simulator::advance() {
  if (begins_anew_ && !look_at_once()) {
    return false;
  }
  if (result_.end != SimulationEnd::complete) {
    return true;
  }
  borne_at_.reset();
  if (integration_->has_slope()) {  // else that which it met says why
    obstacle_ = {.kind = SimulationObstacle::Kind::no_step};
  }
  note_fastest();
  if (!integration_->step(next_end(), next_turn())) {
    return false;
  }
  ++result_.integrated;
  // A step over a point of a curve, or over the end of a contact, is taken again up to there.
  turn_ = find_turn();
  if (turn_ && *turn_ < integration_->time() - least_step()) {
    step_ = *turn_ - time_;
    restart();
    return true;
  }
  turn_.reset();
  const std::optional<Happening> first = find_first();
  const double end = first ? first->time : std::min(integration_->time(), plan_.duration);
  if (!add_rows(end)) {
    return false;
  }
  look_between_rows(first ? std::lerp(end, integration_->time_before(), kBeforeEvent) : end);
  state_.resize(integration_->state().size());
  end < integration_->time() ? integration_->state_at(end, state_)
                             : void(std::ranges::copy(integration_->state(), state_.begin()));
  Configuration there;
  if (!place(end, state_, there)) {
    return false;
  }
  anchor_ = std::move(there);
  time_ = end;
  const std::size_t free = free_count();
  supplied_ = state_[2 * free];
  lost_ = state_[2 * free + 1];
  note_fastest();
  step_ = integration_->next_step();
  if (first) {
    return meet(*first);
  }
  note_signs();
  return keep_coordinates();
}

bool Simulator::keep_coordinates() {
  const std::optional<MatX> units = system_->follower().unit_rates(anchor_);
  const auto free = static_cast<Eigen::Index>(free_count());
  if (!units || free == 0) {
    return true;
  }
  const MatX moving = units->leftCols(free);
  const std::vector<int> best = independent_rates(network_, moving, {});
  if (static_cast<Eigen::Index>(best.size()) < free) {
    return true;
  }
  MatX pivots(free, free);
  for (Eigen::Index j = 0; j < free; ++j) {
    pivots.row(j) = moving.row(best[static_cast<std::size_t>(j)]);
  }
  if (!(std::abs(pivots.determinant()) > kBetterCoordinates)) {
    return true;
  }
  const std::optional<VecX> rates = joint_rates(anchor_, speeds_of(state_));
  if (!rates) {
    return false;
  }
  ++result_.changes;
  choose_coordinates(best);
  begin_at(time_, *rates);
  return true;
}

bool Simulator::add_rows(double until) {
  const double share = until / plan_.duration;
  while (next_row_ <= plan_.steps && static_cast<double>(next_row_) / plan_.steps <= share) {
    const double time =
        next_row_ == plan_.steps ? plan_.duration : plan_.duration * next_row_ / plan_.steps;
    std::vector<double> y(state_.size());
    state_in_step(time, y);
    if (!add_row(time, y)) {
      return false;
    }
    watch_.take(result_.rows.back(), result_.rows.front());
    ++next_row_;
  }
  return true;
}

bool Simulator::add_row(double time, std::span<const double> y) {
  std::optional<SimulationRow> row = row_at(time, y);
  if (!row) {
    return false;
  }
  if (!row->lacks_accelerations) {
    note_borne(row->borne);
    result_.closure_error =
        std::max(result_.closure_error, closure_error(system_->network(), row->configuration));
  }
  if (!plan_.asks_actions && !row->lacks_accelerations) {
    row->borne.clear();
  }
  result_.rows.push_back(*std::move(row));
  return true;
}

// Smooth within the step, which ends where curves have points and something happens.
void Simulator::look_between_rows(double end) {
  const SimulationObstacle before = obstacle_;
  watch_.look({.begin = integration_->time_before(), .end = end, .regime = starts_},
              result_.rows.front(),
              [&](double time) {
                std::vector<double> y(state_.size());
                state_in_step(time, y);
                std::optional<SimulationRow> row = row_at(time, y);
                if (row) {
                  note_energies(*row);
                }
                return row;
              });
  obstacle_ = before;
}

// Those between rows count too: at the rows all may have gone back.
void Simulator::note_energies(const SimulationRow& row) {
  energy_scale_ = std::max({energy_scale_,
                            row.kinetic.value_or(0.0),
                            std::abs(row.potential - result_.rows.front().potential),
                            std::abs(row.supplied),
                            std::abs(row.lost)});
}

void Simulator::state_in_step(double time, std::vector<double>& y) const {
  if (time <= integration_->time_before()) {
    std::ranges::copy(integration_->state_before(), y.begin());
  } else if (time >= integration_->time()) {
    std::ranges::copy(integration_->state(), y.begin());
  } else {
    integration_->state_at(time, y);
  }
}

// Reactions that press where something slides or sticks, for which the file gives no dimension, and
// teeth that pull.
void Simulator::note_borne(const std::vector<std::optional<double>>& borne) {
  if (borne.empty()) {
    return;
  }
  for (const std::size_t friction : dry_) {
    if (rests(friction)) {
      continue;
    }
    const FrictionLaw law =
        balance_.law_of(friction, 1.0, 0.0, false, [](CouplingId) { return false; });
    for (const IgnoredReaction& one : ignored_reactions(balance_.moved(), law, borne)) {
      const auto known = std::ranges::find_if(result_.ignored, [&](const IgnoredReaction& other) {
        return other.coupling == one.coupling && other.reaction == one.reaction;
      });
      if (known == result_.ignored.end()) {
        result_.ignored.push_back(one);
      } else {
        known->size = std::max(known->size, one.size);
      }
    }
  }
  for (const int action : balance_.pulling(borne)) {
    const double force = *borne[at(action)];
    const auto known = std::ranges::find(result_.pulling, action, &PullingTeeth::action);
    if (known == result_.pulling.end()) {
      result_.pulling.push_back({.action = action, .force = force});
    } else if (std::abs(force) > std::abs(known->force)) {
      known->force = force;
    }
  }
}

namespace {

void forget_actions(SimulationRow& row) {
  const auto forget = [](auto& values) { std::ranges::fill(values, std::nullopt); };
  forget(row.rate_rates);
  forget(row.borne);
  forget(row.reactions);
  forget(row.friction);
  row.actions.clear();
  row.held.clear();
  row.lacks_accelerations = true;
}

}  // namespace

SimulationSolution Simulator::stuck() {
  result_.end = SimulationEnd::stuck;
  result_.obstacle = obstacle_;
  return finish();
}

SimulationSolution Simulator::finish() {
  result_.evaluations = evaluations_;
  result_.time = time_;
  const bool has_last = !result_.rows.empty() && result_.rows.back().time >= time_;
  if (!has_last) {
    // A row that only rounding tells from the last one is that one.
    const double spacing = plan_.duration / plan_.steps;
    const bool is_same =
        !result_.rows.empty() && time_ - result_.rows.back().time <= kSameRow * spacing;
    if (is_same && result_.rows.size() == 1) {
      result_.time = result_.rows.back().time;  // it has not begun
    }
    const bool is_added = result_.time == time_ && add_row(time_, state_);
    if (is_added && is_same) {
      result_.rows.erase(result_.rows.end() - 2);
    }
    if (is_added && result_.end == SimulationEnd::stuck && has_dry()) {
      forget_actions(result_.rows.back());  // those of the last way that was tried
    }
    if (is_added) {
      watch_.take(result_.rows.back(), result_.rows.front());
    }
  }
  for (const SimulationEvent& event : result_.events) {
    watch_.take(event);
  }
  result_.sides = watch_.sides();
  result_.extremes = watch_.extremes();
  result_.looks_between_rows = watch_.sees_all() && parts_left_ > 0;
  for (const SimulationRow& row : result_.rows) {
    const SimulationRow& first = result_.rows.front();
    const std::optional<double> balance = row.balance();
    result_.energy_drift = std::max(
        result_.energy_drift, balance ? std::abs(*balance - first.balance().value_or(0.0)) : 0.0);
    note_energies(row);
  }
  result_.energy_scale = energy_scale_;
  return std::move(result_);
}

}  // namespace kinestat
