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

}  // namespace kinestat
