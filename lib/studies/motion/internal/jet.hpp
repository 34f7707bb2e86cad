// A number that moves: its value with its first and second derivative towards time.
#pragma once

#include <cmath>

#include "core/types.hpp"

namespace kinestat {

/// Arithmetic keeps both derivatives exactly, so that accelerations need no formulas of their own.
struct Jet {
  double value = 0.0;
  double first = 0.0;
  double second = 0.0;

  Jet() = default;

  /// A constant, unless derivatives are given. Not explicit: numbers mix with jets in formulas.
  Jet(double constant, double slope = 0.0, double bend = 0.0)
      : value(constant), first(slope), second(bend) {}

  Jet& operator+=(const Jet& b) {
    value += b.value;
    first += b.first;
    second += b.second;
    return *this;
  }

  Jet& operator-=(const Jet& b) {
    value -= b.value;
    first -= b.first;
    second -= b.second;
    return *this;
  }

  friend Jet operator+(Jet a, const Jet& b) { return a += b; }

  friend Jet operator-(Jet a, const Jet& b) { return a -= b; }

  friend Jet operator-(const Jet& a) { return {-a.value, -a.first, -a.second}; }

  friend Jet operator*(const Jet& a, const Jet& b) {
    return {a.value * b.value,
            a.first * b.value + a.value * b.first,
            a.second * b.value + 2.0 * a.first * b.first + a.value * b.second};
  }
};

/// f(a), given f, f' and f'' at the value of a.
inline Jet chain(double f, double slope, double bend, const Jet& a) {
  return {f, slope * a.first, slope * a.second + bend * a.first * a.first};
}

inline Jet sin(const Jet& a) {
  const double s = std::sin(a.value);
  return chain(s, std::cos(a.value), -s, a);
}

inline Jet cos(const Jet& a) {
  const double c = std::cos(a.value);
  return chain(c, -std::sin(a.value), -c, a);
}

inline Jet sqrt(const Jet& a) {
  const double root = std::sqrt(a.value);
  return chain(root, 0.5 / root, -0.25 / (root * a.value), a);
}

inline Jet reciprocal(const Jet& a) {
  const double x = 1.0 / a.value;
  return chain(x, -x * x, 2.0 * x * x * x, a);
}

inline Jet operator/(const Jet& a, const Jet& b) {
  return a * reciprocal(b);
}

/// The angle of (x, y); its slopes follow from (x dy - y dx)/(x² + y²).
inline Jet atan2(const Jet& y, const Jet& x) {
  const double size = x.value * x.value + y.value * y.value;
  const double turn = x.value * y.first - y.value * x.first;
  const double turn_rate = x.value * y.second - y.value * x.second;
  const double size_rate = 2.0 * (x.value * x.first + y.value * y.first);
  return {std::atan2(y.value, x.value),
          turn / size,
          turn_rate / size - turn * size_rate / (size * size)};
}

inline double value_of(const Jet& a) {
  return a.value;
}

/// Of vectors of numbers or jets.
template <class V>
auto dot(const V& a, const V& b) {
  typename V::Scalar sum = a[0] * b[0];
  for (Eigen::Index i = 1; i < a.size(); ++i) {
    sum += a[i] * b[i];
  }
  return sum;
}

}  // namespace kinestat

template <>
struct Eigen::NumTraits<kinestat::Jet> : Eigen::GenericNumTraits<kinestat::Jet> {
  using Real = kinestat::Jet;
  using NonInteger = kinestat::Jet;
  using Nested = kinestat::Jet;
  using Literal = double;

  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 3,
    AddCost = 3,
    MulCost = 8
  };
};
