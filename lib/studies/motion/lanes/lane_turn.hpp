// Where a rate turns back between two steps of a motion.
#pragma once

#include <cstddef>

namespace kinestat {

/// A cubic from its ends and slopes, by the part of the way between.
double lane_cubic(double low, double high, double low_slope, double high_slope, double part);

enum class TurnWithin { none, one, at_low, at_high, unknown };

/// The rates at the ends of a step, and their slopes by the step.
struct LaneRates {
  double low = 0.0;
  double high = 0.0;
  double low_slope = 0.0;
  double high_slope = 0.0;

  /// How often they turn back between; unknown unless that is clear although the slopes are taken
  /// from differences. At an end: nowhere but there, or so near that rounding hides on which side.
  TurnWithin turns() const;
};

/// A dead point on the way to it, in parts of its step.
struct LaneTurn {
  std::size_t step = 0;     ///< the last before it
  std::size_t watched = 0;  ///< of which watched freedom
  bool is_there = false;
  double low = 0.0;  ///< the bracket and the rates at its ends
  double high = 1.0;
  double low_rate = 0.0;
  double high_rate = 0.0;
  double size = 0.0;  ///< of the rates at first
  double rate = 0.0;  ///< at the last trial
  int last = 0;       ///< which end that replaced

  /// Where to try next.
  double next() const;

  /// Takes the rate that was found there.
  void shrink(double found);
};

}  // namespace kinestat
