#include "math/bounded_number.hpp"

#include <cmath>
#include <limits>

namespace kinestat {

namespace {

constexpr double kUnit = std::numeric_limits<double>::epsilon() / 2.0;
constexpr double kWithin = 1.0 + 16.0 * kUnit;  // the few roundings of the bound itself

bool is_sure_zero(const BoundedNumber& number) {
  return number.value == 0.0 && number.bound == 0.0;
}

// With the rounding of the value, which may have been below the smallest number. Nothing is known
// where infinite bounds meet zeros.
BoundedNumber rounded(double value, double bound) {
  const double rounding = kUnit * std::abs(value) + std::numeric_limits<double>::denorm_min();
  const double all = (bound + rounding) * kWithin;
  return {.value = value, .bound = all >= 0.0 ? all : std::numeric_limits<double>::infinity()};
}

}  // namespace

double BoundedNumber::relative_bound() const {
  if (bound == 0.0) {
    return 0.0;
  }
  return bound < std::abs(value) ? bound / std::abs(value) : 1.0;
}

BoundedNumber operator+(const BoundedNumber& a, const BoundedNumber& b) {
  const BoundedNumber sum = rounded(a.value + b.value, a.bound + b.bound);
  return a.bound == 0.0 && b.bound == 0.0 && sum.value == 0.0 ? BoundedNumber{} : sum;
}

BoundedNumber operator-(const BoundedNumber& a, const BoundedNumber& b) {
  return a + BoundedNumber{.value = -b.value, .bound = b.bound};
}

BoundedNumber operator*(const BoundedNumber& a, const BoundedNumber& b) {
  if (is_sure_zero(a) || is_sure_zero(b)) {
    return {};
  }
  return rounded(a.value * b.value,
                 std::abs(a.value) * b.bound + std::abs(b.value) * a.bound + a.bound * b.bound);
}

BoundedNumber operator/(const BoundedNumber& a, const BoundedNumber& b) {
  const double quotient = a.value / b.value;
  if (is_sure_zero(a) && std::abs(b.value) > b.bound) {
    return {};
  }
  const double smallest = std::abs(b.value) - b.bound * kWithin;
  const double bound = smallest > 0.0 ? (a.bound + std::abs(quotient) * b.bound) / smallest
                                      : std::numeric_limits<double>::infinity();
  return rounded(quotient, bound);
}

}  // namespace kinestat
