// How far the values of a row lie apart.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

#include "core/tolerance.hpp"

namespace kinestat {

/// The largest of some values and the least of them that is not zero, of so many rows at once; a
/// NaN is no value.
template <std::size_t rows>
class SizesOf {
 public:
  SizesOf() {
    for (std::size_t i = 0; i < rows; ++i) {
      largest_[i] = 0.0;
      least_[i] = std::numeric_limits<double>::infinity();
    }
  }

  /// A value of each row. Without branches, so that compilers take all rows at once.
  void add(const double* values) {
    for (std::size_t i = 0; i < rows; ++i) {
      const double size = std::abs(values[i]);
      const double beyond_zero = size > 0.0 ? size : std::numeric_limits<double>::infinity();
      largest_[i] = size > largest_[i] ? size : largest_[i];
      least_[i] = beyond_zero < least_[i] ? beyond_zero : least_[i];
    }
  }

  /// A value of all rows, beside which theirs may be rounding; it is none itself.
  void compare_with(double value) {
    for (std::size_t i = 0; i < rows; ++i) {
      largest_[i] = value > largest_[i] ? value : largest_[i];
    }
  }

  /// Whether the least may be what rounding left of the largest. Whether it is zero only the bounds
  /// of an analysis tell, so that this decides on nothing but whether to ask for them.
  bool are_apart(std::size_t row) const { return least_[row] < kSameValue * largest_[row]; }

 private:
  double largest_[rows];
  double least_[rows];
};

/// Of one row.
class Sizes {
 public:
  void add(double value) { sizes_.add(&value); }

  void compare_with(double value) { sizes_.compare_with(value); }

  bool are_apart() const { return sizes_.are_apart(0); }

 private:
  SizesOf<1> sizes_;
};

}  // namespace kinestat
