#include "studies/simulation/internal/simulator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "core/index.hpp"
#include "core/simulation_tolerance.hpp"
#include "core/tolerance.hpp"
#include "studies/motion/configuration.hpp"

namespace kinestat {

namespace {

// Coordinates are changed where others tell the free motions apart by so many times more.
constexpr double kBetterCoordinates = 10.0;

// Where something may happen between steps, there are so many of them at least.
constexpr int kLeastWatched = 100;

// So many events at one time, and steps of the integration, are too many.
constexpr int kMostAtOnce = 1000;
constexpr int kMostSteps = 20'000'000;
constexpr std::size_t kMostEvents = 100'000;

// No more points of curves are sought.
constexpr std::size_t kMostTurns = 100'000;

// Those that are more than rounding; a state near a singular one has no accelerations.
std::vector<std::optional<double>> reported(std::vector<std::optional<double>> values,
                                            const std::vector<double>& bounds,
                                            std::size_t count) {
  values.resize(count);
  for (std::size_t f = 0; f < count; ++f) {
    if (values[f] && !is_reported(*values[f], bounds[f])) {
      values[f].reset();
    }
  }
  return values;
}

}  // namespace

Simulator::Simulator(const Mechanism& mechanism,
                     const MotionNetwork& network,
                     const SimulationPlan& plan)
    : mechanism_(mechanism), topology_(mechanism.topology), network_(network), plan_(plan) {
  for (const HeldFreedom& one : plan.held) {
    held_.push_back(rate_of_freedom(network, one.of.freedom));
  }
  find_turns();
  rests_.resize(plan.stops.size(), false);
  signs_.resize(plan.goals.size(), 0.0);
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
  while (plan_.duration - time_ > least_step()) {
    const double before = time_;
    const std::size_t told = result_.events.size();
    if (!advance()) {
      return stuck();
    }
    if (!makes_progress(before, told)) {
      return stuck();
    }
    if (result_.end == SimulationEnd::goal) {
      break;
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
  if (result_.integrated > kMostSteps || result_.events.size() > kMostEvents) {
    obstacle_ = {.kind = SimulationObstacle::Kind::too_many_steps};
    return false;
  }
  return true;
}

double Simulator::unit(int freedom) const {
  return topology_.freedoms[at(freedom)].is_rotation ? 1.0 : mechanism_.geometry.length;
}

double Simulator::unit_of(std::size_t drive) const {
  return unit(system_->network().driven_freedoms[drive]);
}

std::vector<int> Simulator::held_rates() const {
  std::vector<int> rates = held_;
  for (std::size_t s = 0; s < rests_.size(); ++s) {
    if (rests_[s]) {
      rates.push_back(rate_of_freedom(network_, plan_.stops[s].of.freedom));
    }
  }
  return rates;
}

void Simulator::choose_coordinates(const std::vector<int>& preferred) {
  JointFollower whole(network_);
  const std::vector<int> held = held_rates();
  std::vector<int> first = held;
  first.insert(first.end(), preferred.begin(), preferred.end());
  std::vector<int> rates = independent_rates(network_, whole.free_motions(anchor_), first);
  const auto is_held = [&](int rate) { return std::ranges::find(held, rate) != held.end(); };
  std::erase_if(rates, is_held);
  const std::size_t count = rates.size();
  rates.insert(rates.end(), held.begin(), held.end());
  system_ = std::make_unique<ReducedSystem>(
      mechanism_, mechanism_.cases.front(), with_drives(network_, rates), count);
}

std::optional<VecX> Simulator::joint_rates(const Configuration& configuration,
                                           std::span<const double> speeds) {
  const std::optional<MatX> units = system_->follower().unit_rates(configuration);
  if (!units) {
    return std::nullopt;
  }
  VecX scaled(static_cast<Eigen::Index>(speeds.size()));
  for (std::size_t d = 0; d < speeds.size(); ++d) {
    scaled[static_cast<Eigen::Index>(d)] = speeds[d] / unit_of(d);
  }
  return *units * scaled;
}

double Simulator::held_speed(std::size_t k) const {
  return k < plan_.held.size() ? plan_.held[k].speed : 0.0;
}

void Simulator::begin_at(double time, const VecX& rates) {
  time_ = time;
  const std::size_t free = free_count();
  std::vector<double> drives(free + system_->held_count());
  system_->follower().read_drives(anchor_, drives);
  held_begin_.assign(drives.begin() + static_cast<std::ptrdiff_t>(free), drives.end());
  held_time_ = time;
  state_.assign(2 * free + 2, 0.0);
  for (std::size_t j = 0; j < free; ++j) {
    state_[j] = drives[j];
    state_[free + j] = rates[system_->network().driven_rates[j]] * unit_of(j);
  }
  state_[2 * free] = supplied_;
  state_[2 * free + 1] = lost_;
  restart();
}

void Simulator::restart() {
  integration_ = std::make_unique<InitialValueProblem>(
      [this](double time, std::span<const double> y, std::span<double> f) {
        return slope(time, y, f);
      },
      [this](std::span<const double> y,
             std::span<const double> f,
             double step,
             std::span<double> most) { allow(y, f, step, most); });
  integration_->start(time_, state_, first_step());
}

double Simulator::first_step() const {
  const double most = plan_.duration / std::max(plan_.steps, 10);
  return step_ ? std::min(*step_, most) : most * 0.01;
}

std::vector<double> Simulator::drives_at(double time, std::span<const double> y) const {
  const std::size_t free = free_count();
  std::vector<double> drives(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(free));
  for (std::size_t k = 0; k < held_begin_.size(); ++k) {
    drives.push_back(held_begin_[k] + held_speed(k) * (time - held_time_));
  }
  return drives;
}

std::vector<double> Simulator::speeds_of(std::span<const double> y) const {
  const auto free = static_cast<std::ptrdiff_t>(free_count());
  std::vector<double> speeds(y.begin() + free, y.begin() + 2 * free);
  for (std::size_t k = 0; k < held_begin_.size(); ++k) {
    speeds.push_back(held_speed(k));
  }
  return speeds;
}

bool Simulator::place(double time, std::span<const double> y, Configuration& configuration) {
  configuration = anchor_;
  if (system_->follower().follow(configuration, drives_at(time, y))) {
    return true;
  }
  // Where something failed before in the step, that is why.
  if (obstacle_.kind == SimulationObstacle::Kind::no_step) {
    obstacle_ = {.kind = SimulationObstacle::Kind::no_branch};
  }
  return false;
}

bool Simulator::accelerate(double time,
                           const Configuration& configuration,
                           std::span<const double> y,
                           std::span<double> accelerations) {
  ++result_.evaluations;
  if (system_->accelerate(time, configuration, speeds_of(y), accelerations)) {
    return true;
  }
  obstacle_ = system_->obstacle();
  return false;
}

bool Simulator::slope(double time, std::span<const double> y, std::span<double> f) {
  const std::size_t free = free_count();
  Configuration configuration;
  if (!place(time, y, configuration) ||
      !accelerate(time, configuration, y, f.subspan(free, free))) {
    return false;
  }
  std::copy_n(y.begin() + static_cast<std::ptrdiff_t>(free), free, f.begin());
  f[2 * free] = system_->supplied();
  f[2 * free + 1] = system_->lost();
  return true;
}

void Simulator::allow(std::span<const double> y,
                      std::span<const double> f,
                      double step,
                      std::span<double> most) {
  const std::size_t free = free_count();
  double fastest = fastest_;
  for (std::size_t j = 0; j < free; ++j) {
    fastest = std::max(
        {fastest, std::abs(y[free + j]) / unit_of(j), step * std::abs(f[free + j]) / unit_of(j)});
  }
  for (std::size_t j = 0; j < free; ++j) {
    most[j] = plan_.tolerance * unit_of(j);
    most[free + j] = fastest > 0.0 ? plan_.tolerance * unit_of(j) * fastest
                                   : std::numeric_limits<double>::infinity();
  }
  most[2 * free] = std::numeric_limits<double>::infinity();
  most[2 * free + 1] = std::numeric_limits<double>::infinity();
}

// What begins or ends at a time is seen by the steps before and behind it; where something might
// happen unseen there are no long ones.
double Simulator::next_end() const {
  const bool is_watched =
      !plan_.stops.empty() || !plan_.goals.empty() || !mechanism_.curves.empty();
  const auto turn = std::ranges::upper_bound(turns_, time_ + least_step());
  double end = turn == turns_.end() ? plan_.duration : std::min(plan_.duration, *turn);
  end = std::min(end, turn_.value_or(end));
  const double watched = time_ + plan_.duration / std::max(plan_.steps, kLeastWatched);
  return is_watched && watched < end - least_step() ? watched : end;
}

bool Simulator::advance() {
  obstacle_ = {.kind = SimulationObstacle::Kind::no_step};
  if (!integration_->step(next_end())) {
    return false;
  }
  ++result_.integrated;
  // A step over a point of a curve is taken again up to there.
  turn_ = find_turn();
  if (turn_ && *turn_ < integration_->time() - least_step()) {
    step_ = *turn_ - time_;
    restart();
    return true;
  }
  turn_.reset();
  const std::optional<Happening> first = find_first();
  const double end = first ? first->time : integration_->time();
  if (!add_rows(end)) {
    return false;
  }
  state_.resize(integration_->state().size());
  first ? integration_->state_at(end, state_)
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
  for (std::size_t j = 0; j < free; ++j) {
    fastest_ = std::max(fastest_, std::abs(state_[free + j]) / unit_of(j));
  }
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
    if (time <= integration_->time_before()) {
      std::ranges::copy(integration_->state_before(), y.begin());
    } else if (time >= integration_->time()) {
      std::ranges::copy(integration_->state(), y.begin());
    } else {
      integration_->state_at(time, y);
    }
    if (!add_row(time, y)) {
      return false;
    }
    ++next_row_;
  }
  return true;
}

bool Simulator::add_row(double time, std::span<const double> y) {
  Configuration configuration;
  std::vector<double> accelerations(free_count());
  if (!place(time, y, configuration) || !accelerate(time, configuration, y, accelerations)) {
    return false;
  }
  const std::size_t free = free_count();
  ReducedState now = system_->tell(configuration, speeds_of(y), accelerations);
  const StateBounds& bounds = now.state.bounds;
  const std::size_t count = topology_.freedoms.size();
  now.held.resize(plan_.held.size());
  result_.closure_error =
      std::max(result_.closure_error, closure_error(system_->network(), configuration));
  result_.rows.push_back(
      {.time = time,
       .configuration = std::move(configuration),
       .positions = std::move(now.positions),
       .rates = reported(std::move(now.state.rates), bounds.rates, count),
       .rate_rates = reported(std::move(now.state.rate_rates), bounds.rate_rates, count),
       .actions = std::move(now.actions),
       .held = std::move(now.held),
       .kinetic = now.kinetic,
       .potential = now.potential,
       .supplied = y[2 * free],
       .lost = y[2 * free + 1]});
  return true;
}

SimulationSolution Simulator::stuck() {
  result_.end = SimulationEnd::stuck;
  result_.obstacle = obstacle_;
  return finish();
}

SimulationSolution Simulator::finish() {
  const bool has_last = !result_.rows.empty() && result_.rows.back().time >= time_;
  if (!has_last) {
    (void)add_row(time_, state_);
  }
  for (const SimulationRow& row : result_.rows) {
    const SimulationRow& first = result_.rows.front();
    result_.energy_drift =
        std::max(result_.energy_drift, std::abs(row.balance() - first.balance()));
    result_.energy_scale = std::max({result_.energy_scale,
                                     row.kinetic,
                                     std::abs(row.potential - first.potential),
                                     std::abs(row.supplied),
                                     std::abs(row.lost)});
  }
  return std::move(result_);
}

}  // namespace kinestat
