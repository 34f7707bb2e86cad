#include "studies/motion/lanes/lane_turn.hpp"

#include <algorithm>
#include <cmath>

#include "core/motion_tolerance.hpp"

namespace kinestat {

namespace {

// A rate does not turn back where it is farther from zero than this share of its slopes, twice the
// most by which a cubic falls below its ends: slopes by differences are off.
constexpr double kMostBySlope = 2.0 * 4.0 / 27.0;
constexpr double kClearShare = 0.1;
constexpr int kCubicParts = 16;

}  // namespace

double lane_cubic(double low, double high, double low_slope, double high_slope, double part) {
  const double rest = 1.0 - part;
  return rest * rest * ((1.0 + 2.0 * part) * low + part * low_slope) +
         part * part * ((1.0 + 2.0 * rest) * high - rest * high_slope);
}

TurnWithin LaneRates::turns() const {
  const double sense = low < 0.0 ? -1.0 : 1.0;
  const double before = sense * low;
  const double after = sense * high;
  const double setting_out = sense * low_slope;
  const double arriving = sense * high_slope;
  const double slopes = std::abs(low_slope) + std::abs(high_slope);
  const double size = std::max(std::abs(low), std::abs(high));
  const double least = kClearShare * (after - before);
  const bool is_steady = least < 0.0 ? setting_out <= least && arriving <= least
                                     : least > 0.0 && setting_out >= least && arriving >= least;
  if (!(std::min(std::abs(low), std::abs(high)) > kDoubtfulRate * size)) {
    const TurnWithin end =
        std::abs(low) < std::abs(high) ? TurnWithin::at_low : TurnWithin::at_high;
    return is_steady ? end : TurnWithin::unknown;
  }
  if (after < 0.0) {
    return is_steady ? TurnWithin::one : TurnWithin::unknown;
  }
  if (std::min(before, after) > kMostBySlope * slopes + kClearShare * size) {
    return TurnWithin::none;
  }
  const auto at_part = [&](int i) {
    return lane_cubic(before, after, setting_out, arriving, static_cast<double>(i) / kCubicParts);
  };
  int lowest = 0;
  for (int i = 1; i <= kCubicParts; ++i) {
    lowest = at_part(i) < at_part(lowest) ? i : lowest;
  }
  const double change = kClearShare * std::abs(after - before);
  const bool rises = lowest == 0 && change > 0.0 && setting_out >= change;
  const bool falls = lowest == kCubicParts && change > 0.0 && -arriving >= change;
  return rises || falls || at_part(lowest) > kClearShare * slopes ? TurnWithin::none
                                                                  : TurnWithin::unknown;
}

// The zero of the line through the ends, whose rate counts half where it stayed for two times.
double LaneTurn::next() const {
  return low - low_rate * (high - low) / (high_rate - low_rate);
}

void LaneTurn::shrink(double found) {
  const double t = next();
  rate = found;
  if (std::signbit(found) == std::signbit(low_rate)) {
    low = t;
    low_rate = found;
    high_rate = last == -1 ? high_rate / 2.0 : high_rate;
    last = -1;
  } else {
    high = t;
    high_rate = found;
    low_rate = last == 1 ? low_rate / 2.0 : low_rate;
    last = 1;
  }
}

}  // namespace kinestat
