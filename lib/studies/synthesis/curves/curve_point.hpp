// Points on a circular cubic that are near to given ones.
#pragma once

#include <optional>

#include "studies/synthesis/curves/plane_cubic.hpp"

namespace kinestat {

/// From a point near the curve to one on it, by Newton along the gradient.
Point onto(const PlaneCubic& curve, Point point);

/// Of all points of the curve the nearest. Empty if the curve has none.
std::optional<Point> find_nearest(const PlaneCubic& curve, const Point& point);

}  // namespace kinestat
