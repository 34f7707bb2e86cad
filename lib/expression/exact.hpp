// A number with its exact value where it has one: a fraction times a whole power of pi.
#pragma once

#include <optional>

#include "math/numbers/rational.hpp"

namespace kinestat {

/// factor * π^pi_power; 20 deg is 1/9 * π. Zero has the power 0, so that equal values have equal
/// members.
struct PiRational {
  Rational factor;
  int pi_power = 0;

  friend bool operator==(const PiRational&, const PiRational&) = default;
};

/// The number type of exact evaluation. Exact are: decimals as typed, units, pi, + - * / and whole
/// powers; abs, min, max, floor, ceil, round, mod, gcd; sqrt and hypot that come out even; sines,
/// cosines and tangents of whole parts of a turn with the values 0, ±1/2 and ±1, and their
/// inverses; exp(0), ln(1), log10 of powers of ten. Sums of different powers of pi are not, nor is
/// what grows beyond kLargestRational or follows from anything that is not exact.
struct Exact {
  double value = 0.0;               ///< what evaluation with double gives; it decides on errors
  std::optional<PiRational> exact;  ///< empty: no exact value is known, and `value` is the answer
};

}  // namespace kinestat
