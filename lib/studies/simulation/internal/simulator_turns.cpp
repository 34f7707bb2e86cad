// Where within a step what acts has another law.
#include <algorithm>
#include <cmath>

#include "core/simulation_tolerance.hpp"
#include "core/tolerance.hpp"
#include "math/dense/first_crossing.hpp"
#include "studies/simulation/internal/simulator.hpp"

namespace kinestat {

namespace {

// The first point of a curve on the way from one argument to another; one at which the way begins
// is left behind.
std::optional<double> next_point(const Curve& curve, double from, double to) {
  const double period = curve.period.value_or(0.0);
  const double near = kAtPoint * (curve.at.back() - curve.at.front());
  std::optional<double> next;
  for (const double at : curve.at) {
    double point = at;
    if (period > 0.0) {
      point += period * (to > from ? std::ceil((from + near - at) / period)
                                   : std::floor((from - near - at) / period));
    }
    const bool is_ahead =
        to > from ? point > from + near && point < to : point < from - near && point > to;
    if (is_ahead && (!next || std::abs(point - from) < std::abs(*next - from))) {
      next = point;
    }
  }
  return next;
}

}  // namespace

std::optional<double> Simulator::find_turn() {
  const double from = integration_->time_before() + 2.0 * least_step();  // not the last one again
  const double to = integration_->time();
  std::optional<double> first;
  if (from >= to) {
    return first;
  }
  for (const Curve& curve : mechanism_.curves) {
    if (curve.over == Curve::Over::time) {
      continue;
    }
    const auto argument = [&](double time) {
      std::vector<double> y(state_.size());
      time == to ? void(std::ranges::copy(integration_->state(), y.begin()))
                 : integration_->state_at(time, y);
      return curve.over == Curve::Over::position ? position_at(curve.freedom, time, y)
                                                 : speed_at(curve.freedom, time, y);
    };
    const std::optional<double> before = argument(from);
    const std::optional<double> behind = argument(first.value_or(to));
    const std::optional<double> point =
        before && behind ? next_point(curve, *before, *behind) : std::nullopt;
    if (!point) {
      continue;
    }
    double low = from;
    double high = first.value_or(to);
    const double side = *before < *point ? 1.0 : -1.0;
    while (high - low > 2.0 * kEpsilon * std::abs(high)) {
      const double middle = 0.5 * (low + high);
      if (middle <= low || middle >= high) {
        break;
      }
      (side * (*point - argument(middle).value_or(*point)) > 0.0 ? low : high) = middle;
    }
    first = high;
  }
  for (const std::size_t spring : one_sided_springs_) {
    const auto look_at = [&](double (ReducedSystem::*of)(std::size_t) const) {
      const std::optional<double> turn = spring_turn(spring, of, from, first.value_or(to));
      first = turn ? turn : first;
    };
    const Spring& one = mechanism_.springs[spring];
    look_at(&ReducedSystem::uncut_tension);
    if (one.damping != 0.0) {
      look_at(&ReducedSystem::uncut_tension_at_rest);
    }
    // There the power that is stored begins, and that of the force goes on.
    if (one.force.value != 0.0 || one.force.law != nullptr) {
      look_at(&ReducedSystem::uncut_elastic_tension);
    }
  }
  return first;
}

std::optional<double> Simulator::spring_turn(std::size_t spring,
                                             double (ReducedSystem::*of)(std::size_t) const,
                                             double from,
                                             double to) {
  std::vector<double> ignored(free_count());
  const auto tension = [&](double time) -> std::optional<double> {
    std::vector<double> y(state_.size());
    time == integration_->time() ? void(std::ranges::copy(integration_->state(), y.begin()))
                                 : integration_->state_at(time, y);
    Configuration there;
    return place(time, y, there) && accelerate(time, there, y, ignored)
               ? std::optional(((*system_).*of)(spring))
               : std::nullopt;
  };
  const std::optional<double> before = tension(from);
  if (!before) {
    return std::nullopt;
  }
  const double side = *before < 0.0 ? -1.0 : 1.0;
  const auto distance = [&](double time) {
    const std::optional<double> there = tension(time);
    return there ? std::optional(side * *there) : std::nullopt;
  };
  const std::optional<SignChange> crossing = find_crossing(distance, from, to, parts_of(from, to));
  if (!crossing) {
    return std::nullopt;
  }
  double low = crossing->before;
  double high = crossing->behind;
  while (high - low > 2.0 * kEpsilon * std::abs(high)) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) {
      break;
    }
    (distance(middle).value_or(-1.0) < 0.0 ? high : low) = middle;
  }
  return high;
}

}  // namespace kinestat
