#include "studies/motion/task/cycle/find_actuators.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "core/index.hpp"
#include "core/motion_tolerance.hpp"
#include "core/tolerance.hpp"
#include "math/numbers/zero_within_bound.hpp"
#include "power/efficiency.hpp"

namespace kinestat {

namespace {

// For pictures.
constexpr int kActuatorPoints = 360;

// Between the points of Gauss a polynomial may cross zero.
constexpr int kLooksAPiece = 32;

// Functions along the motion: first those of the whole, then three an actuator.
constexpr std::size_t kKinetic = 0;
constexpr std::size_t kSupplied = 1;
constexpr std::size_t kLoads = 2;
constexpr std::size_t kLost = 3;
constexpr std::size_t kBalance = 4;
constexpr std::size_t kFirstActuator = 5;
constexpr std::size_t kAction = 0;
constexpr std::size_t kPower = 1;
constexpr std::size_t kSpeed = 2;
constexpr std::size_t kOfActuator = 3;

// Behind these the powers of all actuators and of all loads, of a case that names both ends.

double sum_of(const std::vector<double>& powers) {
  return std::accumulate(powers.begin(), powers.end(), 0.0);
}

class ActuatorFinder {
 public:
  ActuatorFinder(CycleSampler& sampler, std::span<const WatchedActuator> plan)
      : sampler_(sampler),
        topology_(sampler.mechanism().topology),
        plan_(plan),
        duration_(sampler.motion().plan.schedule->duration()) {}

  std::variant<WatchedMotion, CycleProblem> run() {
    find_ends();
    auto found = sampler_.find([this](const MotionPosition& at) { return read(at); });
    if (!found) {
      return CycleProblem{
          "in some position of the motion an action or a power has no value, or it jumps too "
          "often, or rounding leaves it too few digits",
          "the rows of the motion say where"};
    }
    found_ = std::move(found);
    points_ = gauss_points(static_cast<int>(found_->pieces().front().values.rows()));
    WatchedMotion result;
    for (std::size_t i = 0; i < plan_.size(); ++i) {
      result.actuators.push_back(figures_of(i));
    }
    result.energy = energy();
    return result;
  }

 private:
  static std::size_t function_of(std::size_t actuator, std::size_t which) {
    return kFirstActuator + kOfActuator * actuator + which;
  }

  std::optional<std::vector<CycleValue>> read(const MotionPosition& at) const {
    const CaseAnalysis* const solved = at.without_friction ? &*at.without_friction
                                       : at.solved         ? &*at.solved
                                                           : nullptr;
    if (solved == nullptr || !solved->dynamics || !solved->power || !solved->action ||
        solved->action->magnitudes.empty() || at.state.rates.empty()) {
      return std::nullopt;
    }
    const PowerFlow& power = *solved->power;
    const LossyState* const lossy = lossy_state_of(*solved);
    if (lossy == nullptr && !sampler_.mechanism().lossy_meshes.empty()) {
      return std::nullopt;
    }
    const auto& actions = lossy != nullptr ? lossy->actions : solved->action->magnitudes;
    const auto& actuators = lossy != nullptr ? lossy->actuators : power.actuators;
    const double largest = largest_of(*solved);
    std::vector<CycleValue> values = whole_of(*solved, lossy);
    for (const WatchedActuator& one : plan_) {
      const ActuatorTopology& actuator = topology_.actuators[kinestat::at(one.actuator)];
      const auto& action = actions[kinestat::at(actuator.action)];
      const auto& rate = at.state.rates[kinestat::at(actuator.freedom)];
      if (!action || !rate) {
        return std::nullopt;
      }
      const auto& bias = solved->dynamics->reduced.value().bias;
      const double inertial = bias.size() > 0 ? bias.lpNorm<Eigen::Infinity>() : 0.0;
      values.push_back({.value = *action, .size = std::max(std::abs(*action), inertial)});
      values.push_back({.value = actuators[kinestat::at(one.actuator)], .size = largest});
      values.push_back({.value = *rate, .size = std::abs(*rate)});
    }
    if (ends_) {
      for (const double one : actuators) {
        values.push_back({.value = one, .size = largest});
      }
      for (std::size_t l = 0; l < ends_->loads.size(); ++l) {
        values.push_back({.value = power.loads[l], .size = largest});
      }
    }
    return values;
  }

  // Of what acts in the position; a coupling with friction and a drive may have none in sum.
  static double largest_of(const CaseAnalysis& solved) {
    const PowerFlow& power = *solved.power;
    double largest = std::max(power.largest, std::abs(solved.dynamics->kinetic_energy_rate));
    for (const auto* const list : {&power.actuators, &power.friction}) {
      for (const double one : *list) {
        largest = std::max(largest, std::abs(one));
      }
    }
    return largest;
  }

  // `lossy` where meshes lose power.
  static std::vector<CycleValue> whole_of(const CaseAnalysis& solved, const LossyState* lossy) {
    const PowerFlow& power = *solved.power;
    const double supplied = sum_of(lossy != nullptr ? lossy->actuators : power.actuators);
    double lost = -sum_of(lossy != nullptr ? lossy->friction : power.friction);
    double balance = sum_of(power.supplied);
    if (lossy != nullptr) {
      for (const MeshLossPower& one : lossy->meshes) {
        lost -= one.power;
      }
      balance = supplied - lost;
    }
    double loads = 0.0;
    for (std::size_t l = 0; l < power.loads.size(); ++l) {
      const bool is_inertia = solved.which.loads[l].name.starts_with(kInertiaPrefix);
      loads += is_inertia ? 0.0 : power.loads[l];
    }
    const double kinetic = solved.dynamics->kinetic_energy;
    const double largest = largest_of(solved);
    return {{.value = kinetic, .size = kinetic},
            {.value = supplied, .size = largest},
            {.value = loads, .size = largest},
            {.value = lost, .size = largest},
            {.value = balance + loads, .size = largest}};
  }

  // Where a function jumps, the polynomial of its narrow piece is none: its next value counts.
  double value_of(std::size_t function, double time) const {
    const auto& pieces = found_->pieces();
    const auto behind = std::ranges::upper_bound(pieces, time, {}, &LegendrePieces::Piece::from);
    const LegendrePieces::Piece& piece = behind == pieces.begin() ? *behind : *(behind - 1);
    if (piece.tail <= kCycleNoise) {
      return found_->value(function, time);
    }
    const double x = (2.0 * time - piece.from - piece.to) / (piece.to - piece.from);
    Eigen::Index nearest = 0;
    (points_.points.array() - x).abs().minCoeff(&nearest);
    return piece.values(nearest, static_cast<Eigen::Index>(function));
  }

  PlacedValue peak_of(std::size_t function) const {
    const GreatestValue greatest =
        found_->greatest([&](double time) { return std::abs(value_of(function, time)); });
    const double value = value_of(function, greatest.argument);
    return {.value = zero_within_bound(std::copysign(greatest.value, value),
                                       kNoHarmonic * found_->size(function)),
            .at = sampler_.drive_at(greatest.argument)};
  }

  double integral_of(std::size_t function) const {
    return duration_ *
           zero_within_bound(found_->integral(function), kNoHarmonic * found_->size(function));
  }

  // Where a function passes zero, in order, with both ends.
  std::vector<double> zeros_of(std::size_t function) const {
    std::vector<double> zeros = {found_->from()};
    double before = value_of(function, found_->from());
    double from = found_->from();
    for (const LegendrePieces::Piece& piece : found_->pieces()) {
      for (int i = 1; i <= kLooksAPiece; ++i) {
        const double to = piece.from + (piece.to - piece.from) * i / kLooksAPiece;
        const double behind = found_->value(function, to);
        if (before * behind < 0.0) {
          zeros.push_back(zero_between(function, from, to, before));
        }
        if (behind != 0.0) {  // it may rest at zero for a while
          before = behind;
          from = to;
        }
      }
    }
    zeros.push_back(found_->to());
    return zeros;
  }

  double zero_between(std::size_t function, double low, double high, double at_low) const {
    while (high - low > kEpsilon * (found_->to() - found_->from())) {
      const double middle = 0.5 * (low + high);
      if (middle <= low || middle >= high) {
        break;
      }
      (found_->value(function, middle) * at_low > 0.0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  // What it gives and takes: between zeros the integrals have one sign.
  void add_energies(std::size_t power, ActuatorFigures& to) const {
    const std::vector<double> zeros = zeros_of(power);
    const double least = kNoHarmonic * found_->size(power);
    double given = 0.0;
    double taken = 0.0;
    for (std::size_t i = 1; i < zeros.size(); ++i) {
      const double part = found_->integral(power, zeros[i]) - found_->integral(power, zeros[i - 1]);
      (part > 0.0 ? given : taken) += std::abs(part);
    }
    to.energy_in = duration_ * zero_within_bound(given, least);
    to.energy_out = duration_ * zero_within_bound(taken, least);
  }

  ActuatorFigures figures_of(std::size_t i) {
    const ActuatorTopology& actuator = topology_.actuators[at(plan_[i].actuator)];
    const std::size_t action = function_of(i, kAction);
    const std::size_t power = function_of(i, kPower);
    const std::size_t speed = function_of(i, kSpeed);
    ActuatorFigures figures;
    figures.name = actuator.name;
    figures.turns = topology_.freedoms[at(actuator.freedom)].is_rotation;
    figures.peak = peak_of(action);
    figures.mean = integral_of(action) / duration_;
    double square = 0.0;
    found_->for_each_point(1.0, [&](double, double weight, const VecX& values) {
      square += weight * std::pow(values[static_cast<Eigen::Index>(action)], 2);
    });
    figures.rms = zero_within_bound(std::sqrt(square), kNoHarmonic * found_->size(action));
    figures.peak_speed = peak_of(speed);
    figures.peak_power = peak_of(power);
    figures.mean_power = integral_of(power) / duration_;
    add_energies(power, figures);
    for (int p = 0; p <= kActuatorPoints; ++p) {
      const double time = static_cast<double>(p) / kActuatorPoints;
      figures.path.push_back({.time = time * duration_,
                              .drive = sampler_.drive_at(time),
                              .speed = value_of(speed, time),
                              .action = value_of(action, time)});
    }
    return figures;
  }

  EnergyFigures energy() {
    EnergyFigures figures{.actuators = integral_of(kSupplied),
                          .loads = integral_of(kLoads),
                          .lost = integral_of(kLost),
                          .has_lossy_meshes = !sampler_.mechanism().lossy_meshes.empty(),
                          .kinetic_change = 0.0,
                          .greatest_kinetic = peak_of(kKinetic).value,
                          .audit = {},
                          .efficiency = {},
                          .no_efficiency = {}};
    const double change =
        found_->value(kKinetic, found_->to()) - found_->value(kKinetic, found_->from());
    figures.kinetic_change = zero_within_bound(change, kNoHarmonic * found_->size(kKinetic));
    if (figures.greatest_kinetic > 0.0) {
      figures.audit =
          std::abs(change - duration_ * found_->integral(kBalance)) / figures.greatest_kinetic;
    }
    add_efficiency(figures);
    return figures;
  }

  // The case with the loads that it has on the way, but those of inertia, which come last.
  void find_ends() {
    const std::optional<MotionPosition> begin = sampler_.at(0.0);
    if (begin && begin->solved && begin->solved->which.names_both_ends()) {
      ends_ = begin->solved->which;
      std::erase_if(ends_->loads,
                    [](const Load& one) { return one.name.starts_with(kInertiaPrefix); });
    }
  }

  // By the energies of the whole instead of powers.
  void add_efficiency(EnergyFigures& figures) const {
    if (!ends_) {
      return;
    }
    std::vector<double> actuators;
    std::vector<double> loads;
    double largest = 0.0;
    std::size_t function = function_of(plan_.size(), 0);
    for (auto* const list : {&actuators, &loads}) {
      const std::size_t count = list == &loads ? ends_->loads.size() : topology_.actuators.size();
      for (std::size_t i = 0; i < count; ++i) {
        list->push_back(integral_of(function++));
        largest = std::max(largest, std::abs(list->back()));
      }
    }
    if (figures.kinetic_change != 0.0) {
      figures.no_efficiency = "kinetic energy at the end differs from that at the start";
      return;
    }
    Efficiency found = find_efficiency(
        topology_, *ends_, {.actuators = actuators, .loads = loads, .largest = largest});
    figures.efficiency = found.value;
    figures.no_efficiency = std::move(found.reason);
  }

  CycleSampler& sampler_;
  const Topology& topology_;
  std::span<const WatchedActuator> plan_;
  std::optional<Case> ends_;  // if it names both
  double duration_ = 0.0;
  GaussPoints points_;
  std::optional<LegendrePieces> found_;
};

}  // namespace

std::variant<WatchedMotion, CycleProblem> find_actuators(CycleSampler& sampler,
                                                         std::span<const WatchedActuator> plan) {
  return ActuatorFinder(sampler, plan).run();
}

}  // namespace kinestat
