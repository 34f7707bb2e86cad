#include "studies/synthesis/dyads/circle_point_choice.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/contract.hpp"
#include "studies/synthesis/curves/cubic_branches.hpp"

namespace kinestat {

namespace {

// From a point near the curve to one on it: Newton along the gradient, which is the linear part of
// the curve written about the point.
Point onto(const PlaneCubic& curve, Point point) {
  constexpr int kSteps = 6;
  for (int i = 0; i < kSteps; ++i) {
    const PlaneCubic local = curve.about(point, curve.length);
    const Point gradient(local.l[0], local.l[1]);
    const double square = std::norm(gradient);
    if (!(square > 0.0)) {
      return point;
    }
    point -= curve.length * local.c / square * gradient;
  }
  return point;
}

}  // namespace

CirclePointChoice::CirclePointChoice(std::vector<PositionJets> positions,
                                     const CirclePointArea& area)
    : positions_(std::move(positions)), area_(area) {
  const int count = position_count(positions_);
  KINESTAT_EXPECTS(count == 3 || count == 4);
  if (count == 4) {
    curves_ = find_curves(positions_);
    if (curves_->status == BurmesterStatus::solved) {
      find_steps(area);
    }
  }
}

void CirclePointChoice::find_steps(const CirclePointArea& area) {
  constexpr int kPoints = 2000;
  const Pose first = pose_of(positions_[0]);
  const Point middle = first.place(0.5 * (area.from + area.to));
  const double radius = 0.5 * std::abs(area.to - area.from);
  const Point half = 0.5 * (area.to - area.from);
  const auto is_inside = [&](const Point& fixed) {
    const Point away = unit_vector(-first.angle) * (fixed - middle);
    return std::abs(away.real()) <= std::abs(half.real()) &&
           std::abs(away.imag()) <= std::abs(half.imag());
  };
  double length = 0.0;
  for (const CurveBranch& branch : sample(curves_->circle_points, middle, radius, kPoints)) {
    for (std::size_t i = 1; i < branch.points.size(); ++i) {
      const Step step{.from = branch.points[i - 1],
                      .to = branch.points[i],
                      .before = length,
                      .length = std::abs(branch.points[i] - branch.points[i - 1])};
      if (is_inside(step.from) && is_inside(step.to)) {
        steps_.push_back(step);
        length += step.length;
      }
    }
  }
}

std::vector<SelectionRange> CirclePointChoice::ranges(int samples) const {
  if (curves_ && steps_.empty()) {
    return {};
  }
  const double numbers = curves_ ? 2.0 : 4.0;
  const int count = samples_along(samples, numbers);
  if (curves_) {
    return {2, SelectionRange{.from = 0.0, .to = 1.0, .count = count}};
  }
  const SelectionRange x{.from = area_.from.real(), .to = area_.to.real(), .count = count};
  const SelectionRange y{.from = area_.from.imag(), .to = area_.to.imag(), .count = count};
  return {x, y, x, y};
}

Point CirclePointChoice::on_curve(double share) const {
  const double at = share * (steps_.back().before + steps_.back().length);
  const auto after = std::ranges::upper_bound(steps_, at, {}, &Step::before);
  const Step& step = after == steps_.begin() ? *after : *(after - 1);
  const double part =
      step.length > 0.0 ? std::clamp((at - step.before) / step.length, 0.0, 1.0) : 0.0;
  return onto(curves_->circle_points, step.from + part * (step.to - step.from));
}

// In the fixed frame, at the first position.
Point CirclePointChoice::circle_point(std::span<const double> numbers) const {
  return curves_ ? on_curve(numbers[0]) : pose_of(positions_[0]).place({numbers[0], numbers[1]});
}

std::vector<Dyad> CirclePointChoice::dyads(std::span<const double> numbers) const {
  const std::size_t each = numbers.size() / 2;
  const auto one = find_dyad(positions_, circle_point(numbers.first(each)));
  const auto other = find_dyad(positions_, circle_point(numbers.subspan(each)));
  if (!one || !other || one->circle_point == other->circle_point) {
    return {};
  }
  return {*one, *other};
}

std::optional<LinkageCandidate> CirclePointChoice::candidate(std::span<const double> numbers,
                                                             const LinkageLimits& limits) const {
  std::vector<LinkageCandidate> found = rank_linkages(dyads(numbers), positions_, limits);
  return found.empty() ? std::nullopt : std::optional(std::move(found.front()));
}

}  // namespace kinestat
