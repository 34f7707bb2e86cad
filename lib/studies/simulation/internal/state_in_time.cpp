#include "studies/simulation/internal/state_in_time.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "core/index.hpp"
#include "core/simulation_tolerance.hpp"
#include "core/tolerance.hpp"
#include "math/numbers/zero_within_bound.hpp"
#include "mechanism/couplings/one_sided_actions.hpp"
#include "studies/motion/configuration.hpp"
#include "studies/motion/contact_rates.hpp"

namespace kinestat {

namespace {

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

// What was added up over time is rounded by some roundings of the largest that it has been.
std::vector<std::optional<double>> settled(std::vector<std::optional<double>> values,
                                           std::vector<double>& largest) {
  constexpr double kRoundings = 16.0;
  largest.resize(values.size(), 0.0);
  for (std::size_t f = 0; f < values.size(); ++f) {
    if (values[f]) {
      largest[f] = std::max(largest[f], std::abs(*values[f]));
      values[f] = zero_within_bound(*values[f], kRoundings * kEpsilon * largest[f]);
    }
  }
  return values;
}

}  // namespace

StateInTime::StateInTime(const Mechanism& mechanism,
                         const MotionNetwork& network,
                         std::span<const DrawnCoupling> drawn,
                         const SimulationPlan& plan)
    : mechanism_(mechanism),
      topology_(mechanism.topology),
      network_(network),
      drawn_(drawn),
      plan_(plan),
      balance_(mechanism, network, drawn),
      frictions_(find_rubbing(mechanism)),
      senses_(frictions_.size()) {
  for (std::size_t i = 0; i < frictions_.size(); ++i) {
    if (frictions_[i].is_dry()) {
      dry_.push_back(i);
    }
  }
  one_sided_ = find_tensions(topology_);
  std::ranges::copy(find_contact_forces(topology_), std::back_inserter(one_sided_));
  needs_balance_ = has_dry() || !one_sided_.empty() || plan.asks_actions;
  for (const HeldFreedom& one : plan.held) {
    held_.push_back(rate_of_freedom(network, one.of.freedom));
  }
  rests_.resize(plan.stops.size(), false);
}

double StateInTime::unit(int freedom) const {
  return topology_.freedoms[at(freedom)].is_rotation ? 1.0 : network_.part_lengths[at(freedom)];
}

double StateInTime::unit_of_rate(int freedom) const {
  return topology_.freedoms[at(freedom)].is_rotation ? 1.0 : network_.length;
}

double StateInTime::unit_of(std::size_t drive) const {
  return unit(system_->network().driven_freedoms[drive]);
}

std::vector<int> StateInTime::held_rates() const {
  std::vector<int> rates = held_;
  for (std::size_t s = 0; s < rests_.size(); ++s) {
    if (rests_[s]) {
      rates.push_back(rate_of_freedom(network_, plan_.stops[s].of.freedom));
    }
  }
  for (const StuckGroup& group : groups_) {
    rates.push_back(rate_of_freedom(network_, freedom_of(group.frictions.front())));
  }
  return rates;
}

// Those of the system before may be preferred.
void StateInTime::choose_coordinates(std::vector<int> preferred) {
  const std::vector<int> held = held_rates();
  slid_at_.reset();
  system_ = make_system(held, preferred);
  const bool is_open =
      std::ranges::any_of(groups_, [](const StuckGroup& one) { return one.frictions.size() > 1; });
  system_->set_friction(senses_, is_open);
  trials_.clear();
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    std::vector<int> others = held;
    others.erase(others.end() - static_cast<std::ptrdiff_t>(groups_.size() - g));
    trials_.push_back(make_system(others, preferred));
  }
}

std::unique_ptr<ReducedSystem> StateInTime::make_system(const std::vector<int>& held,
                                                        const std::vector<int>& preferred) {
  JointFollower whole(network_);
  std::vector<int> first = held;
  first.insert(first.end(), preferred.begin(), preferred.end());
  std::vector<int> rates = independent_rates(network_, whole.free_motions(anchor_), first);
  const auto is_held = [&](int rate) { return std::ranges::find(held, rate) != held.end(); };
  std::erase_if(rates, is_held);
  const std::size_t count = rates.size();
  rates.insert(rates.end(), held.begin(), held.end());
  return std::make_unique<ReducedSystem>(mechanism_,
                                         mechanism_.cases.front(),
                                         with_drives(network_, rates),
                                         count,
                                         needs_balance_ ? &balance_ : nullptr);
}

std::optional<VecX> StateInTime::joint_rates(const Configuration& configuration,
                                             std::span<const double> speeds) {
  const std::optional<MatX> units = system_->follower().unit_rates(configuration);
  if (!units) {
    return std::nullopt;
  }
  VecX scaled(static_cast<Eigen::Index>(speeds.size()));
  for (std::size_t d = 0; d < speeds.size(); ++d) {
    scaled[static_cast<Eigen::Index>(d)] =
        speeds[d] / unit_of_rate(system_->network().driven_freedoms[d]);
  }
  return *units * scaled;
}

double StateInTime::held_speed(std::size_t k) const {
  return k < plan_.held.size() ? plan_.held[k].speed : 0.0;
}

void StateInTime::begin_at(double time, const VecX& rates) {
  time_ = time;
  const std::size_t free = free_count();
  std::vector<double> drives(free + system_->held_count());
  system_->follower().read_drives(anchor_, drives);
  held_begin_.assign(drives.begin() + static_cast<std::ptrdiff_t>(free), drives.end());
  held_time_ = time;
  state_.assign(2 * free + 2, 0.0);
  for (std::size_t j = 0; j < free; ++j) {
    state_[j] = drives[j];
    state_[free + j] = rates[system_->network().driven_rates[j]] *
                       unit_of_rate(system_->network().driven_freedoms[j]);
  }
  state_[2 * free] = supplied_;
  state_[2 * free + 1] = lost_;
  restart();
}

void StateInTime::restart() {
  begins_anew_ = true;
  ++starts_;
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

double StateInTime::first_step() const {
  const double most = plan_.duration / std::max(plan_.steps, 10);
  return step_ ? std::min(*step_, most) : most * 0.01;
}

std::vector<double> StateInTime::drives_at(double time, std::span<const double> y) const {
  const std::size_t free = free_count();
  std::vector<double> drives(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(free));
  for (std::size_t k = 0; k < held_begin_.size(); ++k) {
    drives.push_back(held_begin_[k] + held_speed(k) * (time - held_time_));
  }
  return drives;
}

std::vector<double> StateInTime::speeds_of(std::span<const double> y) const {
  const auto free = static_cast<std::ptrdiff_t>(free_count());
  std::vector<double> speeds(y.begin() + free, y.begin() + 2 * free);
  for (std::size_t k = 0; k < held_begin_.size(); ++k) {
    speeds.push_back(held_speed(k));
  }
  return speeds;
}

bool StateInTime::place(double time, std::span<const double> y, Configuration& configuration) {
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

bool StateInTime::accelerate(double time,
                             const Configuration& configuration,
                             std::span<const double> y,
                             std::span<double> accelerations) {
  ++evaluations_;
  if (system_->accelerate(time, configuration, speeds_of(y), accelerations)) {
    return true;
  }
  obstacle_ = system_->obstacle();
  return false;
}

bool StateInTime::slope(double time, std::span<const double> y, std::span<double> f) {
  const std::size_t free = free_count();
  Configuration configuration;
  if (!place(time, y, configuration) ||
      !accelerate(time, configuration, y, f.subspan(free, free))) {
    return false;
  }
  std::copy_n(y.begin() + static_cast<std::ptrdiff_t>(free), free, f.begin());
  f[2 * free] = system_->powers().supplied;
  f[2 * free + 1] = system_->powers().lost;
  return true;
}

std::optional<SimulationRow> StateInTime::row_at(double time, std::span<const double> y) {
  Configuration configuration;
  std::vector<double> accelerations(free_count());
  if (!place(time, y, configuration)) {
    return std::nullopt;
  }
  if (!accelerate(time, configuration, y, accelerations)) {
    return singular_row_at(time, y, std::move(configuration));
  }
  const std::size_t free = free_count();
  const bool has_actions = plan_.asks_actions || has_dry();
  ReducedState now = system_->tell(configuration, speeds_of(y), accelerations, has_actions);
  add_contact_rates(system_->network(), drawn_, mechanism_, now.state);
  // What sticks alone has all that holds it.
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    if (groups_[g].frictions.size() == 1) {
      now.friction[groups_[g].frictions.front()] = now.held[now.held.size() - groups_.size() + g];
    }
  }
  std::vector<std::optional<Vec3>> reactions;
  if (plan_.asks_actions) {
    reactions = balance_.reactions(now.borne, now.friction, now.state.poses);
  }
  const StateBounds& bounds = now.state.bounds;
  const std::size_t count = topology_.freedoms.size();
  now.held.resize(plan_.held.size());
  return SimulationRow{
      .time = time,
      .configuration = std::move(configuration),
      .positions = settled(std::move(now.positions), largest_.positions),
      .rates = settled(reported(std::move(now.state.rates), bounds.rates, count), largest_.rates),
      .rate_rates = settled(reported(std::move(now.state.rate_rates), bounds.rate_rates, count),
                            largest_.rate_rates),
      .actions = std::move(now.actions),
      .held = std::move(now.held),
      .borne = std::move(now.borne),
      .reactions = std::move(reactions),
      .load_powers = {now.load_powers.begin(), now.load_powers.end()},
      .friction = std::move(now.friction),
      .springs = std::move(now.springs),
      .kinetic = now.kinetic,
      .potential = now.potential,
      .supplied = y[2 * free],
      .lost = y[2 * free + 1]};
}

std::optional<SimulationRow> StateInTime::singular_row_at(double time,
                                                          std::span<const double> y,
                                                          Configuration configuration) {
  std::optional<ReducedState> now = system_->tell_singular(configuration, speeds_of(y));
  if (!now) {
    obstacle_ = system_->obstacle();
    return std::nullopt;
  }
  add_contact_rates(system_->network(), drawn_, mechanism_, now->state);
  const std::size_t count = topology_.freedoms.size();
  const std::size_t free = free_count();
  using Unknown = std::vector<std::optional<double>>;
  return SimulationRow{
      .time = time,
      .configuration = std::move(configuration),
      .positions = settled(std::move(now->positions), largest_.positions),
      .rates = settled(reported(now->state.rates, now->state.bounds.rates, count), largest_.rates),
      .rate_rates = Unknown(count),
      .borne = Unknown(topology_.actions.size()),
      .friction = Unknown(frictions_.size()),
      .kinetic = now->kinetic,
      .potential = now->potential,
      .supplied = y[2 * free],
      .lost = y[2 * free + 1],
      .lacks_accelerations = true};
}

void StateInTime::allow(std::span<const double> y,
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
  // Work follows from these, but for that of what is held: it swings where they are steady.
  const bool is_held =
      std::ranges::any_of(plan_.held, [](const HeldFreedom& one) { return one.speed != 0.0; });
  const double in_step = step * std::max(std::abs(f[2 * free]), std::abs(f[2 * free + 1]));
  const double energy = is_held ? std::max(energy_scale_, in_step) : 0.0;
  for (std::size_t work = 2 * free; work < 2 * free + 2; ++work) {
    most[work] = energy > 0.0 ? plan_.tolerance * energy : std::numeric_limits<double>::infinity();
  }
}

std::optional<double> StateInTime::position_at(int freedom,
                                               double time,
                                               std::span<const double> y) {
  const std::vector<int>& driven = system_->network().driven_freedoms;
  const auto drive = std::ranges::find(driven, freedom);
  if (drive != driven.end()) {
    return drives_at(time, y)[static_cast<std::size_t>(drive - driven.begin())];
  }
  Configuration configuration;
  return place(time, y, configuration)
             ? freedom_positions(system_->network(), mechanism_, configuration)[at(freedom)]
             : std::nullopt;
}

std::optional<double> StateInTime::speed_at(int freedom, double time, std::span<const double> y) {
  const std::vector<int>& driven = system_->network().driven_freedoms;
  const auto drive = std::ranges::find(driven, freedom);
  if (drive != driven.end()) {
    return speeds_of(y)[static_cast<std::size_t>(drive - driven.begin())];
  }
  Configuration configuration;
  std::vector<double> ignored(free_count());
  if (!place(time, y, configuration) || !accelerate(time, configuration, y, ignored)) {
    return std::nullopt;
  }
  const VecX along = system_->direction_of(freedom);
  const std::vector<double> speeds = speeds_of(y);
  return along.dot(Eigen::Map<const VecX>(speeds.data(), along.size()));
}

bool StateInTime::go_on_with(const VecX& rates) {
  choose_coordinates(system_->network().driven_rates);
  begin_at(time_, rates);
  return true;
}

double StateInTime::speed_along(int freedom) const {
  const std::vector<double> speeds = speeds_of(state_);
  const VecX along = system_->direction_of(freedom);
  return along.dot(Eigen::Map<const VecX>(speeds.data(), along.size()));
}

int StateInTime::freedom_of(std::size_t friction) const {
  return frictions_[friction].slides.front().freedom;
}

void StateInTime::note_fastest() {
  const std::size_t free = free_count();
  for (std::size_t j = 0; j < free; ++j) {
    fastest_ = std::max(fastest_, std::abs(state_[free + j]) / unit_of(j));
  }
}

double StateInTime::fastest() const {
  double most = fastest_;
  const std::vector<double> speeds = speeds_of(state_);
  for (std::size_t d = 0; d < speeds.size(); ++d) {
    most = std::max(most, std::abs(speeds[d]) / unit_of(d));
  }
  return most;
}

std::optional<double> StateInTime::sliding_at(std::size_t friction,
                                              double time,
                                              std::span<const double> y) {
  if (slid_at_ != time) {
    Configuration configuration;
    if (!place(time, y, configuration)) {
      return std::nullopt;
    }
    slid_ = system_->rates(configuration, speeds_of(y));
    slid_at_ = time;
  }
  double sum = 0.0;
  for (const SlidingTerm& term : frictions_[friction].slides) {
    const std::size_t freedom = at(term.freedom);
    if (freedom >= slid_.size() || !slid_[freedom]) {
      return std::nullopt;
    }
    sum += term.factor * *slid_[freedom];
  }
  return sum;
}

}  // namespace kinestat
