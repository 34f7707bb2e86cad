#include "studies/synthesis/curves/curve_point.hpp"

#include <algorithm>
#include <cmath>

#include "studies/synthesis/curves/cubic_branches.hpp"

namespace kinestat {

namespace {

// The linear part of the curve written about the point.
Point gradient_at(const PlaneCubic& local) {
  return {local.l[0], local.l[1]};
}

// A circle about the point with that radius meets the curve for certain, if it has points.
double reach(const PlaneCubic& curve, const Point& point) {
  double reach = std::abs(point - curve.centre) + curve.length;
  if (const auto focus = curve.focus()) {
    reach = std::max(reach, std::abs(point - *focus));
  }
  if (const auto circle = curve.circle()) {
    reach = std::max(reach, std::abs(point - circle->centre) + circle->radius);
  }
  if (const auto line = curve.line()) {
    reach = std::max(reach, std::abs(dot(line->normal, point) - line->offset));
  }
  return reach;
}

// Along the tangent towards the point, less far where that leads away from it.
Point slide(const PlaneCubic& curve, const Point& start, const Point& point) {
  constexpr int kSteps = 100;
  constexpr int kHalvings = 30;
  Point at = start;
  double share = 1.0;
  int halvings = 0;
  for (int i = 0; i < kSteps && halvings < kHalvings; ++i) {
    const Point gradient = gradient_at(curve.about(at, curve.length));
    if (!(std::norm(gradient) > 0.0)) {
      break;
    }
    const Point tangent = left_of(gradient) / std::abs(gradient);
    const Point next = onto(curve, at + share * dot(point - at, tangent) * tangent);
    if (std::abs(point - next) < std::abs(point - at)) {
      at = next;
    } else {
      share *= 0.5;
      ++halvings;
    }
  }
  return at;
}

}  // namespace

Point onto(const PlaneCubic& curve, Point point) {
  constexpr int kSteps = 6;
  for (int i = 0; i < kSteps; ++i) {
    const PlaneCubic local = curve.about(point, curve.length);
    const Point gradient = gradient_at(local);
    const double square = std::norm(gradient);
    if (!(square > 0.0)) {
      return point;
    }
    point -= curve.length * local.c / square * gradient;
  }
  return point;
}

std::optional<Point> find_nearest(const PlaneCubic& curve, const Point& point) {
  constexpr int kPoints = 4000;
  std::optional<Point> nearest;
  for (const CurveBranch& branch : sample(curve, point, 1.1 * reach(curve, point), kPoints)) {
    for (const Point& one : branch.points) {
      if (!nearest || std::abs(one - point) < std::abs(*nearest - point)) {
        nearest = one;
      }
    }
  }
  return nearest ? std::optional(slide(curve, onto(curve, *nearest), point)) : std::nullopt;
}

}  // namespace kinestat
