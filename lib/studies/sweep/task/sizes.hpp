// How far the values of a row lie apart.
#pragma once

#include <cmath>
#include <limits>

#include "core/tolerance.hpp"

namespace kinestat {

/// The largest of some values and the least of them that is not zero; a NaN is no value.
class Sizes {
 public:
  void add(double value) {
    const double size = std::abs(value);
    largest_ = size > largest_ ? size : largest_;
    least_ = size > 0.0 && size < least_ ? size : least_;
  }

  /// Whether the least may be what rounding left of the largest. Whether it is zero only the bounds
  /// of an analysis tell, so that this decides on nothing but whether to ask for them.
  bool are_apart() const { return least_ < kSameValue * largest_; }

 private:
  double largest_ = 0.0;
  double least_ = std::numeric_limits<double>::infinity();
};

}  // namespace kinestat
