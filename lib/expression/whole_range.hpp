// Ranges that count exactly: their values are the doubles that would be typed there.
#pragma once

#include <optional>

#include "expression/exact.hpp"
#include "expression/units.hpp"

namespace kinestat {

/// The value counted in a unit, where that is a fraction.
std::optional<Rational> exact_count(const Exact& value, const UnitScale& unit);

/// A range over whole numbers of a common share of the unit.
struct WholeRange {
  double from = 0.0;
  double step = 0.0;
  double denominator = 1.0;
  double last = 0.0;  ///< index

  double at(double index) const { return (from + index * step) / denominator; }
};

/// Empty where a count is not a fraction, or a whole number is too large for a double.
std::optional<WholeRange> whole_range(const std::optional<Rational>& from,
                                      const std::optional<Rational>& to,
                                      const std::optional<Rational>& step);

}  // namespace kinestat
