#include "synthesis/path_curvature.hpp"

#include <cmath>

#include "core/tolerance.hpp"

namespace kinestat {

namespace {

// Empty where powers of a path that is almost at rest leave the range of numbers.
std::optional<double> in_range(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace

PathCurvature find_path_curvature(const PositionJets& position, const Point& moving) {
  PathCurvature result;
  if (position.order() < 3) {
    return result;
  }
  const std::vector<Point> z = point_jets(position, moving);
  // K = N q^(-3/2) with N = Z' x Z'' and q = Z' . Z'.
  const double q = std::norm(z[1]);
  const double size =
      std::abs(position.angle[1]) * std::abs(moving) + std::abs(origin(position, 1));
  if (!(std::sqrt(q) > kCancellation * size)) {
    return result;
  }
  const double n = cross(z[1], z[2]);
  const double root = std::sqrt(q);
  result.k = in_range(n / (q * root));
  if (position.order() < 4) {
    return result;
  }
  const double q1 = 2.0 * dot(z[1], z[2]);
  const double n1 = cross(z[1], z[3]);
  result.k_prime = in_range((n1 - 1.5 * n * q1 / q) / (q * root));
  if (position.order() < 5) {
    return result;
  }
  const double q2 = 2.0 * (std::norm(z[2]) + dot(z[1], z[3]));
  const double n2 = cross(z[2], z[3]) + cross(z[1], z[4]);
  result.k_second = in_range(
      (n2 - 3.0 * n1 * q1 / q - 1.5 * n * q2 / q + 3.75 * n * q1 * q1 / (q * q)) / (q * root));
  return result;
}

}  // namespace kinestat
