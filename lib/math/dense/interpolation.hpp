// Curves through points: cubics between neighbours, given by their slopes at the points.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "math/numbers/dual.hpp"

namespace kinestat {

/// From a point to the next one.
template <class Scalar>
struct Secant {
  Scalar width;
  Scalar slope;
};

template <class Scalar>
Secant<Scalar> secant(std::span<const Scalar> at, std::span<const Scalar> values, std::size_t i) {
  const Scalar width = at[i + 1] - at[i];
  return {.width = width, .slope = (values[i + 1] - values[i]) / width};
}

/// Slopes that leave a cubic as monotone as its points are (Fritsch and Butland 1984, p. 300 to
/// 304): between two chords their harmonic mean, weighted by their widths; none where they differ
/// in sense.
template <class Scalar>
Scalar monotone_slope_between(const Secant<Scalar>& a, const Secant<Scalar>& b) {
  if (value_of(a.slope) * value_of(b.slope) <= 0.0) {
    return 0.0;
  }
  const Scalar first = Scalar(2.0) * b.width + a.width;
  const Scalar second = b.width + Scalar(2.0) * a.width;
  return (first + second) / (first / a.slope + second / b.slope);
}

/// Likewise at an end that the chord `a` begins, which `b` follows: that of a parabola through
/// three points, cut off.
template <class Scalar>
Scalar monotone_slope_at_end(const Secant<Scalar>& a, const Secant<Scalar>& b) {
  const Scalar slope =
      ((Scalar(2.0) * a.width + b.width) * a.slope - a.width * b.slope) / Scalar(a.width + b.width);
  if (value_of(slope) * value_of(a.slope) <= 0.0) {
    return 0.0;
  }
  const bool turns = value_of(a.slope) * value_of(b.slope) <= 0.0;
  const bool is_steep = std::abs(value_of(slope)) > 3.0 * std::abs(value_of(a.slope));
  return turns && is_steep ? Scalar(Scalar(3.0) * a.slope) : slope;
}

/// At a point of a curve that ends with its points.
template <class Scalar>
Scalar monotone_slope(std::span<const Scalar> at, std::span<const Scalar> values, std::size_t i) {
  const std::size_t last = at.size() - 1;
  if (last == 1) {
    return secant(at, values, 0).slope;
  }
  if (i == 0) {
    return monotone_slope_at_end(secant(at, values, 0), secant(at, values, 1));
  }
  return i == last
             ? monotone_slope_at_end(secant(at, values, last - 1), secant(at, values, last - 2))
             : monotone_slope_between(secant(at, values, i - 1), secant(at, values, i));
}

/// Of the cubic over a chord from `value` on, with slopes `from` and `to` at its ends; `t` from 0
/// to 1.
template <class Scalar>
Scalar hermite(const Scalar& value,
               const Secant<Scalar>& one,
               const Scalar& from,
               const Scalar& to,
               const Scalar& t) {
  // The chord, and how the slopes at its ends differ from its own.
  const Scalar rest = Scalar(1.0) - t;
  return value + one.width * (t * one.slope +
                              t * rest * (rest * (from - one.slope) - t * (to - one.slope)));
}

/// The chord of rising places in which x lies; the first or the last beyond them.
std::size_t interval_of(std::span<const double> at, double x);

/// What a cubic spline, whose second derivative is continuous, does at its ends.
enum class SplineEnds {
  natural,  ///< no second derivative
  rest,     ///< no slope
  periodic  ///< it goes on as it began; the last value is the first one
};

/// Slopes at the points, at least two; periodic ones at least three.
std::vector<double> spline_slopes(std::span<const double> at,
                                  std::span<const double> values,
                                  SplineEnds ends);

/// Those of monotone cubics; `is_periodic`: the last value is the first one, and they go on.
std::vector<double> monotone_slopes(std::span<const double> at,
                                    std::span<const double> values,
                                    bool is_periodic);

/// A curve at a place, with its derivatives.
struct CurvePoint {
  double value = 0.0;
  double slope = 0.0;
  double bend = 0.0;
};

/// Straight between the points where there are no slopes. Where a derivative jumps it is that
/// behind the jump, at the end that before.
CurvePoint interpolated(std::span<const double> at,
                        std::span<const double> values,
                        std::span<const double> slopes,
                        double x);

}  // namespace kinestat
