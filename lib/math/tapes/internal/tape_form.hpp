// A number of a tape by its inputs, where it is a sum of multiples of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "core/tolerance.hpp"
#include "math/tapes/internal/tape_range.hpp"

namespace kinestat {

/// centre + Σ slope · input, from which the number differs by at most `error` in every lane, as it
/// is rounded. Where two operands hang on the same input, it tells more than their ranges do.
struct TapeForm {
  struct Slope {
    int input = 0;
    double slope = 0.0;
    TapeRange range;  ///< of the input
  };

  double centre = 0.0;
  std::vector<Slope> slopes;
  double size = 0.0;  ///< at least the sum of the magnitudes of all terms that were summed
  double error = 0.0;
};

/// Of a number that is its own input.
inline TapeForm form_of_input(int input, const TapeRange& range) {
  return {.centre = 0.0,
          .slopes = {{.input = input, .slope = 1.0, .range = range}},
          .size = range.most(),
          .error = 0.0};
}

inline TapeForm form_of_constant(double value) {
  return {.centre = value, .slopes = {}, .size = std::abs(value), .error = 0.0};
}

/// With what one more operation of the tape rounds, and what working out the form does: each at
/// most half an epsilon of a term.
inline TapeForm with_rounding(TapeForm form) {
  constexpr double kRoundings = 4.0;
  form.error +=
      kRoundings * kEpsilon * (form.size + form.error) + std::numeric_limits<double>::min();
  return form;
}

/// factor · a
inline TapeForm operator*(double factor, TapeForm a) {
  a.centre *= factor;
  for (TapeForm::Slope& one : a.slopes) {
    one.slope *= factor;
  }
  a.size *= std::abs(factor);
  a.error *= std::abs(factor);
  return with_rounding(std::move(a));
}

inline TapeForm operator+(const TapeForm& a, const TapeForm& b) {
  TapeForm sum{.centre = a.centre + b.centre,
               .slopes = a.slopes,
               .size = a.size + b.size,
               .error = a.error + b.error};
  for (const TapeForm::Slope& one : b.slopes) {
    const auto present = std::ranges::find(sum.slopes, one.input, &TapeForm::Slope::input);
    if (present == sum.slopes.end()) {
      sum.slopes.push_back(one);
    } else {
      present->slope += one.slope;
    }
  }
  return with_rounding(std::move(sum));
}

/// a + factor · b, where both are affine.
inline std::optional<TapeForm> sum_of(const std::optional<TapeForm>& a,
                                      double factor,
                                      const std::optional<TapeForm>& b) {
  return a && b ? std::optional(*a + factor * *b) : std::nullopt;
}

/// What `range` leaves of the values that the form may have; all of it where the form says nothing.
inline TapeRange narrowed(const TapeRange& range, const TapeForm& form) {
  double low = form.centre;
  double high = form.centre;
  for (const TapeForm::Slope& one : form.slopes) {
    const double a = one.slope * one.range.low;
    const double b = one.slope * one.range.high;
    low += std::min(a, b);
    high += std::max(a, b);
  }
  const double terms = static_cast<double>(form.slopes.size()) + 1.0;
  const double error = form.error + terms * kEpsilon * form.size;
  low -= 2.0 * error;
  high += 2.0 * error;
  return std::isfinite(low) && std::isfinite(high)
             ? TapeRange{std::max(range.low, low), std::min(range.high, high)}
             : range;
}

}  // namespace kinestat
