// A part of a path of drives, and the straight line between its ends.
#pragma once

#include <cstddef>
#include <vector>

#include "studies/motion/motion_solution.hpp"

namespace kinestat {

/// Between two shares of a path, within which each drive runs one way or rests.
class PathLeg {
 public:
  /// `units` are those of the drives: 1 rad, or the size of the mechanism. Both must outlive it.
  PathLeg(const DrivePath& path, const std::vector<double>& units, double from, double to);

  double from() const { return from_; }

  double to() const { return to_; }

  /// Where the drives are at its ends, in their units.
  const std::vector<double>& low() const { return low_; }

  const std::vector<double>& high() const { return high_; }

  bool moves() const { return low_ != high_; }

  /// How far the drives part from the straight line on the way, in their units.
  double bow() const;

  bool can_be_halved() const;

  /// The share of the path where the fastest drive is as far as at that share of the line.
  double share(double of_line) const;

  /// The share of the line where that drive is at a share of the path.
  double part_at(double share) const;

 private:
  double drive_at(std::size_t drive, double share) const;

  const DrivePath& path_;
  const std::vector<double>& units_;
  double from_;
  double to_;
  std::vector<double> low_;
  std::vector<double> high_;
  std::size_t fastest_ = 0;
};

}  // namespace kinestat
