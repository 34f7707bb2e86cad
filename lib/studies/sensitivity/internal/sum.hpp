// A sum that knows its rounding.
#pragma once

#include <cmath>

#include "core/tolerance.hpp"

namespace kinestat {

/// A sum with the size of its terms, by which it counts as zero if it is their rounding.
struct Sum {
  double value = 0.0;
  double size = 0.0;

  void add(double term) {
    value += term;
    size += std::abs(term);
  }

  double rounded() const { return std::abs(value) <= kCancellation * size ? 0.0 : value; }
};

}  // namespace kinestat
