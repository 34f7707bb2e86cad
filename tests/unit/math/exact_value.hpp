// The fractions that sums of doubles are.
#pragma once

#include "math/numbers/double_double.hpp"
#include "math/numbers/rational.hpp"

namespace kinestat {

inline Rational exact(double value) {
  return Rational(value);
}

inline Rational exact(DoubleDouble value) {
  return Rational(value.high) + Rational(value.low);
}

}  // namespace kinestat
