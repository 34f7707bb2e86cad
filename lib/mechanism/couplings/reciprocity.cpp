#include "mechanism/couplings/reciprocity.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/tolerance.hpp"
#include "math/numbers/dual_vector.hpp"

namespace kinestat {

namespace {

Vec3 slope_of(const Vec3Of<Dual>& vector, std::size_t p) {
  return {derivative(vector[0], p), derivative(vector[1], p), derivative(vector[2], p)};
}

// Whether parameter p moves the power of the wrench on the twist by more than rounding.
bool moves_power(const NamedTwistOf<Dual>& twist,
                 const NamedWrenchOf<Dual>& wrench,
                 std::size_t p) {
  double sum = 0.0;
  double size = 0.0;
  const auto add = [&](const Vec3Of<Dual>& action, const Vec3Of<Dual>& rate) {
    const Vec3 action_slope = slope_of(action, p);
    const Vec3 rate_slope = slope_of(rate, p);
    sum += action_slope.dot(values_of(rate)) + values_of(action).dot(rate_slope);
    size +=
        action_slope.norm() * values_of(rate).norm() + values_of(action).norm() * rate_slope.norm();
  };
  add(wrench.screw.force, twist.screw.linear);
  add(wrench.screw.moment, twist.screw.angular);
  return std::abs(sum) > kPowerBalance * size;
}

}  // namespace

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

void find_breaking_parameters(const CouplingScrewsOf<Dual>& screws, std::vector<bool>& breaks) {
  for (const NamedTwistOf<Dual>& freedom : screws.freedoms) {
    for (const NamedWrenchOf<Dual>& constraint : screws.constraints) {
      for (std::size_t p = 0; p < breaks.size(); ++p) {
        breaks[p] = breaks[p] || moves_power(freedom, constraint, p);
      }
    }
  }
}

}  // namespace kinestat
