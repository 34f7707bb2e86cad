// Whole numbers that rounding has moved.
#pragma once

#include <cmath>

#include "math/numbers/dual.hpp"

namespace kinestat {

/// Whether the value is whole but for its rounding, as 0.3/0.1, which is 3 less one.
inline bool is_settled_whole(double value) {
  return is_tie(value, std::round(value));
}

/// That whole number, or the value itself.
inline double settled_whole(double value) {
  return is_settled_whole(value) ? std::round(value) : value;
}

}  // namespace kinestat
