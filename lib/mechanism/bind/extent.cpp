#include "mechanism/bind/extent.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/tolerance.hpp"
#include "mechanism/couplings/internal/coupling_binder.hpp"

namespace kinestat {

namespace {

// Of points, in one coordinate.
struct Range {
  double low = 0.0;
  double high = 0.0;

  double length() const { return high - low; }

  // What bounds it too, but for rounding.
  double rounding() const { return kCancellation * std::max(std::abs(low), std::abs(high)); }
};

using Points = std::vector<Vec3Of<Dual>>;

Range range_of(const Points& points, Eigen::Index i) {
  const auto [low, high] = std::ranges::minmax_element(
      points, {}, [&](const Vec3Of<Dual>& point) { return point[i].value; });
  return {.low = (*low)[i].value, .high = (*high)[i].value};
}

double steepest_slope(const Points& points, std::size_t p) {
  double steepest = 0.0;
  for (const Vec3Of<Dual>& point : points) {
    for (const Dual& coordinate : point) {
      steepest = std::max(steepest, std::abs(derivative(coordinate, p)));
    }
  }
  return steepest;
}

// The next point of it. What is left of decimals then has no more of them; of a centre that was
// rounded, every coordinate would keep the rounding, and zeros would be nearly zero.
Vec3 on_grid(const Vec3& point, double spacing) {
  return point.unaryExpr([spacing](double x) { return std::round(x / spacing) * spacing; });
}

// How all coordinates at `end` move with the parameter; NaN if they part.
double slope_at(
    const Points& points, Eigen::Index i, double end, const Range& range, std::size_t p) {
  const double rounding = kCancellation * steepest_slope(points, p);
  double slope = std::numeric_limits<double>::quiet_NaN();
  bool is_first = true;
  for (const Vec3Of<Dual>& point : points) {
    if (std::abs(point[i].value - end) <= range.rounding()) {
      const double one = derivative(point[i], p);
      slope = is_first || std::abs(one - slope) <= rounding
                  ? one
                  : std::numeric_limits<double>::quiet_NaN();
      is_first = false;
    }
  }
  return slope;
}

// NaN if the ends part from others; the length of a range is positive.
double slope_of(const Points& points, Eigen::Index i, const Range& range, std::size_t p) {
  return slope_at(points, i, range.high, range, p) - slope_at(points, i, range.low, range, p);
}

}  // namespace

template <class Scalar>
void add_points(const CouplingDescription& coupling,
                const CouplingGeometryOf<Scalar>& geometry,
                std::vector<Vec3Of<Scalar>>& points) {
  if (has_place(coupling)) {
    points.push_back(geometry.at);
  }
  if (coupling.type == CouplingType::cable) {
    points.push_back(geometry.from);
  }
  for (const auto* list : {&coupling.freedoms, &coupling.constraints}) {
    const auto& screws = list == &coupling.freedoms ? geometry.freedoms : geometry.constraints;
    for (std::size_t i = 0; i < list->size(); ++i) {
      if ((*list)[i].at) {
        points.push_back(screws[i].at);
      }
    }
  }
}

template void add_points(const CouplingDescription&, const CouplingGeometry&, std::vector<Vec3>&);
template void add_points(const CouplingDescription&,
                         const CouplingGeometryOf<Dual>&,
                         std::vector<Vec3Of<Dual>>&);

Extent find_extent(const std::vector<Vec3>& points) {
  if (points.empty()) {
    return {};
  }
  Vec3 low = points.front();
  Vec3 high = low;
  for (const Vec3& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const Vec3 centre = low + 0.5 * (high - low);
  // The square of what is very small would be zero.
  const double widest = (high - low).maxCoeff();
  Extent extent;
  extent.length = widest > 0.0 ? std::max(widest, (high - low).norm()) : 1.0;
  if (centre.norm() > kFarOrigin * extent.length) {
    extent.origin = on_grid(centre, std::ldexp(1.0, std::ilogb(extent.length)));
  }
  return extent;
}

// d√(Σ r²) = Σ r dr / √(Σ r²). A range of zero adds nothing, though it has a corner itself; if all
// are, any point that leaves the others makes a jump.
Dual find_length(const std::vector<Vec3Of<Dual>>& points, std::size_t parameter_count) {
  Dual result(1.0, std::vector<double>(parameter_count, 0.0));
  if (points.empty()) {
    return result;
  }
  const std::array<Range, 3> ranges = {
      range_of(points, 0), range_of(points, 1), range_of(points, 2)};
  const double diagonal = Vec3(ranges[0].length(), ranges[1].length(), ranges[2].length()).norm();
  result.value = diagonal > 0.0 ? diagonal : 1.0;
  for (std::size_t p = 0; p < parameter_count; ++p) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      const Range& range = ranges[static_cast<std::size_t>(i)];
      if (range.length() > range.rounding()) {
        result.derivatives[p] += range.length() / diagonal * slope_of(points, i, range, p);
      } else if (!(diagonal > 0.0) && std::isnan(slope_of(points, i, range, p))) {
        result.derivatives[p] = std::numeric_limits<double>::quiet_NaN();
      }
    }
  }
  return result;
}

}  // namespace kinestat
