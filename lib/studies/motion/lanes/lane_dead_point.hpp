// Where rates turn back on the way of a motion.
#pragma once

#include <cstddef>

#include "studies/motion/hermite_cubic.hpp"
#include "studies/motion/lanes/lane_group.hpp"

namespace kinestat {

/// What is known of a position of the drive.
struct LanePoint {
  LaneGroups unknowns;
  LaneGroups rates;  ///< by the drive
};

/// One at which it is looked how the watched freedoms move.
struct LaneLook {
  LaneGroup drive;
  LanePoint point;
  LaneGroups values;  ///< of the watched freedoms
  LaneGroups rates;   ///< by the drive
  LaneGroups bends;   ///< and their derivatives
  LaneGroup fastest;  ///< of all rates
};

/// Between two looks, by their indices; those of the whole way have depth 0.
struct LaneStretch {
  std::size_t low = 0;
  std::size_t high = 0;
  int depth = 0;
};

/// A dead point on the way to it, in parts of its stretch.
class LaneDeadPoint {
 public:
  LaneDeadPoint(const LaneStretch& stretch, std::size_t watched, const HermiteCubic& rate);

  const LaneStretch& stretch() const { return stretch_; }

  std::size_t watched() const { return watched_; }

  /// Where to look next.
  double part() const { return part_; }

  /// Takes the rate there and its slope by the stretch; true if it is zero no farther off than
  /// that.
  bool take(double rate, double slope, double most);

 private:
  LaneStretch stretch_;
  std::size_t watched_ = 0;
  double part_ = 0.0;
  double low_ = 0.0;  // the bracket
  double high_ = 1.0;
  HermiteCubic rate_;  // between its ends; slopes by the whole stretch
};

}  // namespace kinestat
