// Round numbers for examples.
#pragma once

#include <cmath>

namespace kinestat {

/// The next number with one digit that is not below a number above zero: 300 for 287.
inline double round_up_to_one_digit(double value) {
  const double digit = std::pow(10.0, std::floor(std::log10(value)));
  return digit * std::ceil(value / digit);
}

}  // namespace kinestat
