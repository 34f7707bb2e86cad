// A number with a hundred decimal digits, from what the user typed.
#pragma once

#include <optional>

#include "math/numbers/big_float.hpp"

namespace kinestat {

/// The number type of evaluation with many digits: decimals count as typed, units are exact, and
/// all functions are evaluated with the digits of BigFloat.
struct Precise {
  double value = 0.0;               ///< what evaluation with double gives; it decides on errors
  std::optional<BigFloat> precise;  ///< empty: none, where double only has one by its rounding, as
                                    ///< 1/(0.1 + 0.2 - 0.3)
};

}  // namespace kinestat
