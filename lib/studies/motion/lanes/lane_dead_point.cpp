#include "studies/motion/lanes/lane_dead_point.hpp"

#include <cmath>

namespace kinestat {

LaneDeadPoint::LaneDeadPoint(const LaneStretch& stretch,
                             std::size_t watched,
                             const HermiteCubic& rate)
    : stretch_(stretch), watched_(watched), part_(rate.zero()), rate_(rate) {}

bool LaneDeadPoint::take(double rate, double slope, double most) {
  if (std::abs(rate) <= most * std::abs(slope)) {
    return true;
  }
  if (std::signbit(rate) == std::signbit(rate_.low)) {
    low_ = part_;
    rate_.low = rate;
    rate_.low_slope = slope;
  } else {
    high_ = part_;
    rate_.high = rate;
    rate_.high_slope = slope;
  }
  const double width = high_ - low_;
  part_ = low_ + width * HermiteCubic{.low = rate_.low,
                                      .high = rate_.high,
                                      .low_slope = width * rate_.low_slope,
                                      .high_slope = width * rate_.high_slope}
                             .zero();
  return false;
}

}  // namespace kinestat
