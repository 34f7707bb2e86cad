#include "mechanism/reciprocity.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kinestat {

double reciprocity_error(const CouplingScrews& screws, double length) {
  const auto scaled = [&](const Vec3& first, const Vec3& second) {
    const double size = std::max(first.norm(), second.norm() / length);
    return std::pair<Vec3, Vec3>(first / size, second / (size * length));
  };
  double worst = 0.0;
  for (const NamedTwist& freedom : screws.freedoms) {
    const auto [angular, linear] = scaled(freedom.screw.angular, freedom.screw.linear);
    for (const NamedWrench& constraint : screws.constraints) {
      const auto [force, moment] = scaled(constraint.screw.force, constraint.screw.moment);
      worst = std::max(worst, std::abs(force.dot(linear) + moment.dot(angular)));
    }
  }
  return worst;
}

}  // namespace kinestat
