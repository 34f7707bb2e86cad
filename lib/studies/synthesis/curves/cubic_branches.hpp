// A circular cubic as points to draw.
#pragma once

#include <vector>

#include "studies/synthesis/curves/plane_cubic.hpp"

namespace kinestat {

struct CurveBranch {
  std::vector<Point> points;
  bool is_closed = false;
};

/// The part of the curve within a circle, in branches; about `count` points in all. Lines parallel
/// to the asymptote meet the curve in two other points at most, the roots of a quadratic equation:
/// no direction and no number of branches is special. Where the curve falls apart into its
/// asymptote and a circle, the line is a branch.
std::vector<CurveBranch> sample(const PlaneCubic& cubic,
                                const Point& middle,
                                double radius,
                                int count);

}  // namespace kinestat
