// Screws times magnitudes, summed with how far the sum may be off.
#pragma once

#include <cmath>
#include <limits>

#include "core/rounding.hpp"
#include "math/numbers/bounded_arithmetic.hpp"

namespace kinestat {

/// What its bound does not tell from zero becomes zero, in place.
inline void settle(const Vec3& bound, Vec3& value) {
  for (int i = 0; i < 3; ++i) {
    value[i] = zero_within_bound(value[i], bound[i]);
  }
}

/// What bounded_screw gives of each, summed in place: line vectors, and moments about the origin.
class BoundedScrewSum {
 public:
  /// Of screws that are all drawn at that point.
  explicit BoundedScrewSum(const Vec3& point) : distance_(point.cwiseAbs().sum()) {}

  void add(const BoundedNumber& magnitude, const Vec3& line, const Vec3& moment) {
    if (is_sure_zero(magnitude)) {
      return;
    }
    const double direction = line.cwiseAbs().maxCoeff();
    const double arm = distance_ * direction + moment.cwiseAbs().maxCoeff();
    add_to(line_, magnitude, line, kDataRounding * direction);
    add_to(moment_, magnitude, moment, kDataRounding * arm);
  }

  BoundedVector line() const { return finished(line_); }

  BoundedVector moment() const { return finished(moment_); }

 private:
  // Roundings of a bound itself, of as many screws as a coupling has.
  static constexpr double kWithinSum = 1.0 + 128.0 * kUnitRoundoff;

  static void add_to(BoundedVector& sum,
                     const BoundedNumber& magnitude,
                     const Vec3& unit,
                     double rounding) {
    if (rounding == 0.0) {
      return;  // Nothing but zeros.
    }
    const double size = std::abs(magnitude.value);
    for (int i = 0; i < 3; ++i) {
      const double product = magnitude.value * unit[i];
      sum.value[i] += product;
      sum.bound[i] += size * rounding + (std::abs(unit[i]) + rounding) * magnitude.bound +
                      kUnitRoundoff * (std::abs(product) + std::abs(sum.value[i])) +
                      std::numeric_limits<double>::denorm_min();
    }
  }

  // Nothing is known where infinite bounds meet zeros.
  static BoundedVector finished(const BoundedVector& sum) {
    BoundedVector result = sum;
    for (int i = 0; i < 3; ++i) {
      const double bound = kWithinSum * sum.bound[i];
      result.bound[i] = bound >= 0.0 ? bound : std::numeric_limits<double>::infinity();
    }
    return result;
  }

  double distance_ = 0.0;  // of the point, no less than from the origin
  BoundedVector line_;
  BoundedVector moment_;
};

}  // namespace kinestat
