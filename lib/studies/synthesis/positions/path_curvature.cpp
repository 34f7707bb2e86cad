#include "studies/synthesis/positions/path_curvature.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/index.hpp"
#include "studies/synthesis/dyads/bounded_point.hpp"
#include "studies/synthesis/positions/internal/jets.hpp"

namespace kinestat {

namespace {

// Empty where powers of a path that is almost at rest leave the range of numbers.
std::optional<double> in_range(const BoundedNumber& number) {
  return std::isfinite(number.value) ? std::optional(number.zeroed()) : std::nullopt;
}

// What the turning of the plane does to a point, derivative by derivative, by the sizes of the
// terms of each.
std::vector<BoundedPoint> bounded_rotation(const PositionJets& position) {
  const std::vector<Point> jets = rotation_jets(position);
  std::vector<double> sizes{std::max(1.0, std::abs(position.angle[0]))};
  std::vector<BoundedPoint> result;
  for (std::size_t k = 0; k < jets.size(); ++k) {
    if (k > 0) {
      double size = 0.0;
      for (std::size_t i = 0; i < k; ++i) {
        size += binomial(k - 1, i) * std::abs(position.angle[k - i]) * sizes[i];
      }
      sizes.push_back(size);
    }
    const double bound = kDataRounding * sizes[k];
    result.push_back(BoundedPoint::within(jets[k], {bound, bound}));
  }
  return result;
}

std::vector<BoundedPoint> bounded_path(const PositionJets& position, const Point& moving) {
  std::vector<BoundedPoint> result = bounded_rotation(position);
  for (int k = 0; k < position.order(); ++k) {
    result[at(k)] =
        result[at(k)] * BoundedPoint::written(moving) + BoundedPoint::written(origin(position, k));
  }
  return result;
}

}  // namespace

PathCurvature find_path_curvature(const PositionJets& position, const Point& moving) {
  PathCurvature result;
  if (position.order() < 3) {
    return result;
  }
  const std::vector<BoundedPoint> z = bounded_path(position, moving);
  if (z[1].zeroed() == Point(0.0, 0.0)) {
    return result;
  }
  // K = N q^(-3/2) with N = Z' x Z'' and q = Z' . Z'.
  const BoundedNumber q = dot(z[1], z[1]);
  const BoundedNumber cube = q * root(q);
  const BoundedNumber n = cross(z[1], z[2]);
  result.k = in_range(n / cube);
  if (position.order() < 4) {
    return result;
  }
  const BoundedNumber bend = n / q;
  const BoundedNumber q1 = exactly(2.0) * dot(z[1], z[2]);
  const BoundedNumber n1 = cross(z[1], z[3]);
  result.k_prime = in_range((n1 - exactly(1.5) * bend * q1) / cube);
  if (position.order() < 5) {
    return result;
  }
  const BoundedNumber q2 = exactly(2.0) * (dot(z[2], z[2]) + dot(z[1], z[3]));
  const BoundedNumber n2 = cross(z[2], z[3]) + cross(z[1], z[4]);
  result.k_second = in_range((n2 - exactly(3.0) * n1 * q1 / q - exactly(1.5) * bend * q2 +
                              exactly(3.75) * bend * q1 * q1 / q) /
                             cube);
  return result;
}

}  // namespace kinestat
