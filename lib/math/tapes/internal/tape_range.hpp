// The range of a number on a tape, with its arithmetic.
#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "core/tolerance.hpp"

namespace kinestat {

/// What a number of a tape lies between in every lane, as it is rounded. Rounding keeps the order
/// of numbers, so that the ends of an operation are those that its ends give.
struct TapeRange {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  /// Of the magnitude.
  double most() const { return std::max(std::abs(low), std::abs(high)); }

  double least() const { return std::max({low, -high, 0.0}); }
};

/// From the least to the greatest; anything where one of them is no number.
inline TapeRange range_around(std::initializer_list<double> ends) {
  const bool has_ends = std::ranges::none_of(ends, [](double end) { return std::isnan(end); });
  return has_ends ? TapeRange{std::min(ends), std::max(ends)} : TapeRange{};
}

inline TapeRange operator+(const TapeRange& a, const TapeRange& b) {
  return range_around({a.low + b.low, a.high + b.high});
}

inline TapeRange operator-(const TapeRange& a, const TapeRange& b) {
  return range_around({a.low - b.high, a.high - b.low});
}

inline TapeRange operator*(const TapeRange& a, const TapeRange& b) {
  return range_around({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
}

/// Anything where the divisor may be zero.
inline TapeRange operator/(const TapeRange& a, const TapeRange& b) {
  return b.least() > 0.0
             ? range_around({a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high})
             : TapeRange{};
}

/// Of the smaller or larger of two, worked out for the ends; anything where one has no bounds, for
/// it may be no number and still be chosen.
inline TapeRange range_of_choice(const TapeRange& a, const TapeRange& b, const TapeRange& chosen) {
  return std::isfinite(a.most()) && std::isfinite(b.most()) ? chosen : TapeRange{};
}

/// Whether some number of the range is mere rounding of terms of at most that size.
inline bool may_be_rounding(const TapeRange& a, double size) {
  return !(a.least() > kCancellation * size);
}

/// Of a number that is set to zero where it is that.
inline TapeRange without_rounding(const TapeRange& a, double size) {
  return may_be_rounding(a, size) ? TapeRange{std::min(a.low, 0.0), std::max(a.high, 0.0)} : a;
}

}  // namespace kinestat
