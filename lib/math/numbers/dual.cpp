#include "math/numbers/dual.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "math/numbers/typed_angle.hpp"

namespace kinestat {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// A slope times a derivative; what is constant stays so, whatever the slope.
double term(double slope, double derivative) {
  return derivative == 0.0 ? 0.0 : slope * derivative;
}

double finite_or_none(double derivative) {
  return std::isfinite(derivative) ? derivative : kNone;
}

double slope_of_power(double base, double exponent) {
  return exponent == 0.0 ? 0.0 : exponent * std::pow(base, exponent - 1.0);
}

double slope_of_exponent(double base, double exponent, double value) {
  if (base > 0.0) {
    return value * std::log(base);
  }
  return base == 0.0 && exponent > 0.0 ? 0.0 : kNone;
}

// Calls slope(da, db) for every variable; a list that is empty stands for zeros.
template <class Slope>
Dual combine(double value, const Dual& a, const Dual& b, const Slope& slope) {
  const std::size_t count = std::max(a.derivatives.size(), b.derivatives.size());
  KINESTAT_EXPECTS(a.derivatives.empty() || b.derivatives.empty() ||
                   a.derivatives.size() == b.derivatives.size());
  const auto of = [](const Dual& number, std::size_t i) {
    return number.derivatives.empty() ? 0.0 : number.derivatives[i];
  };
  Dual result{value, std::vector<double>(count)};
  for (std::size_t i = 0; i < count; ++i) {
    result.derivatives[i] = finite_or_none(slope(of(a, i), of(b, i)));
  }
  return result;
}

// What a factor adds to the slope of a product with another.
double share_of_product(double factor, double factor_slope, double slope) {
  return factor == 0.0 && factor_slope == 0.0 ? 0.0 : term(factor, slope);
}

// Of one of two values, which may be tied.
Dual choose(double value, bool is_first, const Dual& a, const Dual& b) {
  if (!is_tie(a.value, b.value)) {
    return chain(value, 1.0, is_first ? a : b);
  }
  return combine(value, a, b, [](double da, double db) { return da == db ? da : kNone; });
}

}  // namespace

Dual make_variable(double value, std::size_t index, std::size_t count) {
  KINESTAT_EXPECTS(index < count);
  Dual result{value, std::vector<double>(count, 0.0)};
  result.derivatives[index] = 1.0;
  return result;
}

double derivative(const Dual& number, std::size_t variable) {
  return number.derivatives.empty() ? 0.0 : number.derivatives.at(variable);
}

Dual chain(double value, double by_a, const Dual& a) {
  Dual result{value, a.derivatives};
  for (double& d : result.derivatives) {
    d = finite_or_none(term(by_a, d));
  }
  return result;
}

Dual chain(double value, double by_a, const Dual& a, double by_b, const Dual& b) {
  if (b.derivatives.empty()) {
    return chain(value, by_a, a);
  }
  if (a.derivatives.empty()) {
    return chain(value, by_b, b);
  }
  KINESTAT_EXPECTS(a.derivatives.size() == b.derivatives.size());
  Dual result{value, std::vector<double>(a.derivatives.size())};
  for (std::size_t i = 0; i < result.derivatives.size(); ++i) {
    result.derivatives[i] =
        finite_or_none(term(by_a, a.derivatives[i]) + term(by_b, b.derivatives[i]));
  }
  return result;
}

Dual operator-(const Dual& a) {
  return chain(-a.value, -1.0, a);
}

Dual operator+(const Dual& a, const Dual& b) {
  return chain(a.value + b.value, 1.0, a, 1.0, b);
}

Dual operator-(const Dual& a, const Dual& b) {
  return chain(a.value - b.value, 1.0, a, -1.0, b);
}

Dual operator*(const Dual& a, const Dual& b) {
  return combine(a.value * b.value, a, b, [&](double da, double db) {
    return share_of_product(b.value, db, da) + share_of_product(a.value, da, db);
  });
}

Dual operator/(const Dual& a, const Dual& b) {
  const double quotient = a.value / b.value;
  return chain(quotient, 1.0 / b.value, a, -quotient / b.value, b);
}

Dual sin(const Dual& a) {
  return chain(sine(a.value), cosine(a.value), a);
}

Dual cos(const Dual& a) {
  return chain(cosine(a.value), -sine(a.value), a);
}

Dual tan(const Dual& a) {
  const double value = tangent(a.value);
  return chain(value, 1.0 + value * value, a);
}

// (1 - a)(1 + a) keeps the digits that 1 - a^2 would lose near one.
Dual asin(const Dual& a) {
  return chain(std::asin(a.value), 1.0 / std::sqrt((1.0 - a.value) * (1.0 + a.value)), a);
}

Dual acos(const Dual& a) {
  return chain(std::acos(a.value), -1.0 / std::sqrt((1.0 - a.value) * (1.0 + a.value)), a);
}

Dual atan(const Dual& a) {
  return chain(std::atan(a.value), 1.0 / (1.0 + a.value * a.value), a);
}

// d atan2(y, x) = (x dy - y dx)/r^2; at the origin 0/0 is the NaN that is wanted.
Dual atan2(const Dual& y, const Dual& x) {
  const double r = std::hypot(x.value, y.value);
  return chain(std::atan2(y.value, x.value), x.value / r / r, y, -y.value / r / r, x);
}

Dual sqrt(const Dual& a) {
  const double value = std::sqrt(a.value);
  return chain(value, 0.5 / value, a);
}

Dual abs(const Dual& a) {
  const double slope = a.value > 0.0 ? 1.0 : a.value < 0.0 ? -1.0 : kNone;
  return chain(std::abs(a.value), slope, a);
}

Dual exp(const Dual& a) {
  const double value = std::exp(a.value);
  return chain(value, value, a);
}

Dual log(const Dual& a) {
  return chain(std::log(a.value), 1.0 / a.value, a);
}

Dual log10(const Dual& a) {
  return chain(std::log10(a.value), 1.0 / (a.value * std::numbers::ln10), a);
}

Dual pow(const Dual& base, const Dual& exponent) {
  const double value = std::pow(base.value, exponent.value);
  return chain(value,
               slope_of_power(base.value, exponent.value),
               base,
               slope_of_exponent(base.value, exponent.value, value),
               exponent);
}

Dual staircase(double value, bool jumps, const Dual& a) {
  return chain(value, jumps ? kNone : 0.0, a);
}

Dual staircase(double value, bool jumps, const Dual& a, const Dual& b) {
  const double slope = jumps ? kNone : 0.0;
  return chain(value, slope, a, slope, b);
}

bool is_tie(double a, double b) {
  return std::abs(a - b) <= 4.0 * kEpsilon * std::max(std::abs(a), std::abs(b));
}

Dual min(const Dual& a, const Dual& b) {
  return choose(std::min(a.value, b.value), a.value < b.value, a, b);
}

Dual max(const Dual& a, const Dual& b) {
  return choose(std::max(a.value, b.value), a.value > b.value, a, b);
}

// At the origin 0/0 is the NaN that is wanted.
Dual hypot(const Dual& a, const Dual& b) {
  const double value = std::hypot(a.value, b.value);
  return chain(value, a.value / value, a, b.value / value, b);
}

}  // namespace kinestat
