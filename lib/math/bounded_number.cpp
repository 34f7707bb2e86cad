#include "math/bounded_number.hpp"

#include <cmath>
#include <limits>

namespace kinestat {

namespace {

constexpr double kUnit = std::numeric_limits<double>::epsilon() / 2.0;
constexpr double kWithin = 1.0 + 16.0 * kUnit;  // the few roundings of the bound itself

// A result that is exactly zero without error has no rounding.
BoundedNumber rounded(double value, double bound) {
  const bool is_sure_zero = value == 0.0 && bound == 0.0;
  const double rounding =
      is_sure_zero ? 0.0 : kUnit * std::abs(value) + std::numeric_limits<double>::denorm_min();
  return {.value = value, .bound = (bound + rounding) * kWithin};
}

}  // namespace

double BoundedNumber::relative_bound() const {
  if (bound == 0.0) {
    return 0.0;
  }
  return bound < std::abs(value) ? bound / std::abs(value) : 1.0;
}

BoundedNumber operator+(const BoundedNumber& a, const BoundedNumber& b) {
  return rounded(a.value + b.value, a.bound + b.bound);
}

BoundedNumber operator*(const BoundedNumber& a, const BoundedNumber& b) {
  return rounded(a.value * b.value,
                 std::abs(a.value) * b.bound + std::abs(b.value) * a.bound + a.bound * b.bound);
}

BoundedNumber operator/(const BoundedNumber& a, const BoundedNumber& b) {
  const double quotient = a.value / b.value;
  const double smallest = std::abs(b.value) - b.bound * kWithin;
  const double bound = smallest > 0.0 ? (a.bound + std::abs(quotient) * b.bound) / smallest
                                      : std::numeric_limits<double>::infinity();
  return rounded(quotient, bound);
}

}  // namespace kinestat
