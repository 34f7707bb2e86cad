// Means of a column over the way of a motion, or in time.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "math/dense/smooth_integral.hpp"
#include "studies/motion/task/figures/time_pieces.hpp"

namespace kinestat {

/// What a column has at a position.
struct MeanSample {
  double step = 0.0;
  std::optional<double> value;
  bool rests = false;   ///< friction has no direction there
  double weight = 0.0;  ///< of a point of a piece, as of a TimePoint
};

struct ColumnMeans {
  std::optional<double> mean;
  std::optional<double> mean_square;
};

/// What a motion has between its samples.
struct MeanCourse {
  std::span<const TimePiece> pieces;  ///< of a motion in time
  std::span<const double> corners;    ///< in steps and in order: values are smooth between these
  bool ends_at_limit = false;         ///< of a drive that runs there steadily
};

/// Of samples in order: pieces that have points are integrated by these, and what lies between
/// other corners by polynomials where values are smooth, else along straight lines. Where a sample
/// has no value half of the interval is asked for, by `value_before`: a value before the step `end`
/// that has none, with that share of the way from the step `from` left. Empty where both ends have
/// none, but for rests.
ColumnMeans means_of(
    std::span<const MeanSample> samples,
    const MeanCourse& course,
    const std::function<std::optional<double>(double from, double end, double left)>& value_before,
    SmoothIntegral& integral);

}  // namespace kinestat
