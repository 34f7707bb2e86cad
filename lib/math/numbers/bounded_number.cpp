#include "math/numbers/bounded_number.hpp"

#include <cmath>
#include <limits>

#include "math/numbers/bounded_arithmetic.hpp"

namespace kinestat {

double BoundedNumber::relative_bound() const {
  if (bound == 0.0) {
    return 0.0;
  }
  return bound < std::abs(value) ? bound / std::abs(value) : 1.0;
}

BoundedNumber operator+(const BoundedNumber& a, const BoundedNumber& b) {
  return bounded_sum(a, b);
}

BoundedNumber operator-(const BoundedNumber& a, const BoundedNumber& b) {
  return bounded_difference(a, b);
}

BoundedNumber operator*(const BoundedNumber& a, const BoundedNumber& b) {
  return bounded_product(a, b);
}

BoundedNumber operator/(const BoundedNumber& a, const BoundedNumber& b) {
  const double quotient = a.value / b.value;
  if (is_sure_zero(a) && std::abs(b.value) > b.bound) {
    return {};
  }
  const double smallest = std::abs(b.value) - b.bound * kWithinBound;
  const double bound = smallest > 0.0 ? (a.bound + std::abs(quotient) * b.bound) / smallest
                                      : std::numeric_limits<double>::infinity();
  return with_rounding(quotient, bound);
}

Vec3 BoundedVector::zeroed() const {
  return (value.array().abs() <= bound.array() && bound.array().isFinite())
      .select(Vec3::Zero(), value);
}

BoundedVector rounded_vector(const Vec3& value, double share) {
  return {.value = value, .bound = Vec3::Constant(share * value.cwiseAbs().maxCoeff())};
}

BoundedVector operator+(const BoundedVector& a, const BoundedVector& b) {
  return bounded_sum(a, b);
}

BoundedVector operator-(const BoundedVector& a, const BoundedVector& b) {
  return bounded_difference(a, b);
}

BoundedVector operator*(const BoundedNumber& factor, const BoundedVector& a) {
  return bounded_product(factor, a);
}

BoundedVector cross(const BoundedVector& a, const BoundedVector& b) {
  return bounded_by_component([&](int i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    return bounded_difference(bounded_product(a.component(j), b.component(k)),
                              bounded_product(a.component(k), b.component(j)));
  });
}

BoundedNumber dot(const BoundedVector& a, const BoundedVector& b) {
  return bounded_dot(a, b);
}

}  // namespace kinestat
