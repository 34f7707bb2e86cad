// Numbers of two doubles, for what doubles alone would lose: residuals, and solutions beyond 1e-16.
#pragma once

#include <cmath>

namespace kinestat {

/// The unevaluated sum high + low; low is at most half a unit in the last place of high, so that
/// high is the nearest double. 106 bits, the range of double.
struct DoubleDouble {
  double high = 0.0;
  double low = 0.0;

  friend bool operator==(const DoubleDouble&, const DoubleDouble&) = default;
};

// The two sums and the product below are exact for any rounding the compiler leaves alone: this
// needs -ffp-contract=off and no fast-math, which the options of the project ask for.

/// a + b without error; neither sum may overflow (Knuth, TAOCP 2, 4.2.2, theorem B).
inline DoubleDouble two_sum(double a, double b) {
  const double sum = a + b;
  const double of_b = sum - a;
  return {.high = sum, .low = (a - (sum - of_b)) + (b - of_b)};
}

/// The same for |a| >= |b| or a = 0, in half the operations (Dekker 1971).
inline DoubleDouble quick_two_sum(double a, double b) {
  const double sum = a + b;
  return {.high = sum, .low = b - (sum - a)};
}

/// The upper and lower 26 bits of a: products of such halves are exact (Veltkamp 1968). |a| must
/// stay below 2^996.
inline DoubleDouble split_in_half(double a) {
  constexpr double kSplitter = 0x1p27 + 1.0;
  const double shifted = kSplitter * a;
  const double upper = shifted - (shifted - a);
  return {.high = upper, .low = a - upper};
}

/// a · b without error (Dekker 1971) where |a| and |b| are below 2^996 and the product is 0, or at
/// least 2^-968 and finite. Not by std::fma: without -march=native that is a call into the C
/// library, slower here where the processor can do it and many times slower where it cannot.
inline DoubleDouble two_product(double a, double b) {
  const double product = a * b;
  const DoubleDouble x = split_in_half(a);
  const DoubleDouble y = split_in_half(b);
  const double rest = (x.high * y.high - product) + x.high * y.low + x.low * y.high;
  return {.high = product, .low = rest + x.low * y.low};
}

// The relative error of each operation below is at most 15 · 2^-106, within the ranges of two_sum
// and two_product (Joldes, Muller and Popescu, ACM TOMS 44, 2017), also where a sum cancels.

inline DoubleDouble operator-(DoubleDouble a) {
  return {.high = -a.high, .low = -a.low};
}

inline DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble high = two_sum(a.high, b.high);
  const DoubleDouble low = two_sum(a.low, b.low);
  const DoubleDouble sum = quick_two_sum(high.high, high.low + low.high);
  return quick_two_sum(sum.high, sum.low + low.low);
}

inline DoubleDouble operator-(DoubleDouble a, DoubleDouble b) {
  return a + (-b);
}

inline DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble product = two_product(a.high, b.high);
  return quick_two_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

inline DoubleDouble operator*(DoubleDouble a, double b) {
  const DoubleDouble high = two_product(a.high, b);
  const DoubleDouble low = quick_two_sum(high.high, a.low * b);
  return quick_two_sum(low.high, low.low + high.low);
}

/// b must not be zero.
inline DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
  const double first = a.high / b.high;
  const DoubleDouble left = a - b * first;
  const double second = left.high / b.high;
  const DoubleDouble rest = left - b * second;
  return quick_two_sum(first, second) + DoubleDouble{.high = rest.high / b.high, .low = 0.0};
}

/// The square root of what is not negative: one step of Newton's method after the root of a double
/// (Karp and Markstein, ACM TOMS 23, 1997).
inline DoubleDouble sqrt(DoubleDouble a) {
  if (a.high == 0.0) {
    return {};
  }
  const double root = std::sqrt(a.high);
  const DoubleDouble rest = a - two_product(root, root);
  return quick_two_sum(root, rest.high / (2.0 * root));
}

}  // namespace kinestat
