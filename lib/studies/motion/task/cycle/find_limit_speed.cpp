#include "studies/motion/task/cycle/find_limit_speed.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "core/motion_tolerance.hpp"
#include "mechanism/couplings/one_sided_actions.hpp"

namespace kinestat {

namespace {

constexpr int kSpeedProbes = 12;

class LimitFinder {
 public:
  LimitFinder(CycleSampler& sampler, std::span<const LimitedCoupling> plan)
      : sampler_(sampler), topology_(sampler.mechanism().topology), plan_(plan) {}

  std::variant<std::vector<LimitSpeed>, CycleProblem> run() {
    if (auto problem = why_no_mass(sampler_.mechanism())) {
      return *std::move(problem);
    }
    if (auto problem = why_not_steady(sampler_.mechanism(), sampler_.motion())) {
      return *std::move(problem);
    }
    for (const LimitedCoupling& one : plan_) {
      if (auto problem = add_actions(one)) {
        return *std::move(problem);
      }
    }
    constexpr std::array kPaces = {CyclePace::whole, CyclePace::half};
    const auto found = sampler_.find([this](const MotionPosition& at) { return read(at); }, kPaces);
    if (!found) {
      return CycleProblem{
          "in some position of the motion a force has no value, or it jumps too often, or rounding "
          "leaves it too few digits",
          "the rows of the motion say where"};
    }
    if (!holds_at_twice(*found)) {
      return CycleProblem{"forces depend on speed in another way than inertia forces do",
                          "leave out friction and damping, or look for the speed by hand: the "
                          "least of the force is among the figures of the motion"};
    }
    std::vector<LimitSpeed> limits;
    for (std::size_t i = 0; i < actions_.size(); ++i) {
      limits.push_back(solve(*found, i));
    }
    return limits;
  }

 private:
  std::optional<CycleProblem> add_actions(const LimitedCoupling& one) {
    const std::size_t count = actions_.size();
    for (const auto& one_sided : {find_contact_forces(topology_), find_tensions(topology_)}) {
      std::ranges::copy_if(one_sided, std::back_inserter(actions_), [&](int a) {
        return topology_.actions[static_cast<std::size_t>(a)].coupling == one.coupling;
      });
    }
    if (actions_.size() > count) {
      return std::nullopt;
    }
    return CycleProblem{
        fmt::format("coupling '{}' bears forces both ways", topology_.coupling(one.coupling).name),
        "name contacts, whose surfaces only push, or segments of cables, which only pull",
        one.where};
  }

  std::optional<std::vector<CycleValue>> read(const MotionPosition& at) const {
    if (!at.solved || !at.solved->action || at.solved->action->magnitudes.empty()) {
      return std::nullopt;
    }
    std::vector<CycleValue> values;
    for (const int action : actions_) {
      const std::optional<double>& there =
          at.solved->action->magnitudes[static_cast<std::size_t>(action)];
      if (!there) {
        return std::nullopt;
      }
      values.push_back({.value = *there, .size = std::abs(*there)});
    }
    return values;
  }

  // A + B, of the speed of the case, and B: from that speed and its half.
  std::pair<double, double> parts(const LegendrePieces& found, std::size_t i, double time) const {
    const double whole = found.value(i, time);
    const double half = found.value(i + actions_.size(), time);
    return {whole, 4.0 / 3.0 * (whole - half)};
  }

  bool holds_at_twice(const LegendrePieces& found) {
    for (int p = 0; p < kSpeedProbes; ++p) {
      const double time = (p + 0.5) / kSpeedProbes;
      const std::optional<MotionPosition> fast = sampler_.at(time, CyclePace::twice);
      const auto there = fast ? read(*fast) : std::nullopt;
      if (!there) {
        return false;
      }
      for (std::size_t i = 0; i < actions_.size(); ++i) {
        const auto [whole, by_speed] = parts(found, i, time);
        const double size = found.size(i) + 3.0 * std::abs(by_speed);
        if (std::abs((*there)[i].value - (whole + 3.0 * by_speed)) > kSteady * size) {
          return false;
        }
      }
    }
    return true;
  }

  // Somewhere least is the square of the speed at which A + B w^2 is zero: -A/B where B is negative
  // and A is not.
  LimitSpeed solve(const LegendrePieces& found, std::size_t i) const {
    const auto action = static_cast<std::size_t>(actions_[i]);
    LimitSpeed limit{.coupling = topology_.coupling(topology_.actions[action].coupling).name,
                     .action = topology_.action_name(actions_[i]),
                     .speed = std::nullopt,
                     .at = std::nullopt};
    const double speed = sampler_.drive_speed();
    const double least = kNoHarmonic * found.size(i);
    // With the sign turned, for the greatest is looked for.
    const GreatestValue first = found.greatest([&](double time) {
      const auto [whole, by_speed] = parts(found, i, time);
      const double at_rest = whole - by_speed;
      if (at_rest < -least) {
        return 0.0;
      }
      return by_speed < -least ? std::max(at_rest, 0.0) / by_speed
                               : -std::numeric_limits<double>::infinity();
    });
    if (std::isfinite(first.value)) {
      limit.speed = std::abs(speed) * std::sqrt(-first.value);
      limit.at = sampler_.drive_at(first.argument);
    }
    return limit;
  }

  CycleSampler& sampler_;
  const Topology& topology_;
  std::span<const LimitedCoupling> plan_;
  std::vector<int> actions_;
};

}  // namespace

std::variant<std::vector<LimitSpeed>, CycleProblem> find_limit_speeds(
    CycleSampler& sampler, std::span<const LimitedCoupling> plan) {
  return LimitFinder(sampler, plan).run();
}

}  // namespace kinestat
