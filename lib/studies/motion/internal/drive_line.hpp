// Where all drives of a motion run together.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace kinestat {

/// The line along which they do; in radians, or sizes of the mechanism.
struct DriveLine {
  std::vector<double> from;
  std::vector<double> reach;  ///< to - from
  double scale = 1.0;         ///< the largest of them; 1 where none moves

  /// The share is 0 at `from` and 1 at `to`.
  static DriveLine between(std::span<const double> from, std::span<const double> to);

  double value(std::size_t drive, double share) const { return from[drive] + share * reach[drive]; }

  /// 1 or -1 where the drives run in the directions of the other line, forwards or back; otherwise
  /// 0.
  int sense_in(const DriveLine& other) const;

  /// The share at which the drives are where `share` has them on the other line, whose points are
  /// also those of this one.
  double share_of(const DriveLine& other, double share) const;
};

}  // namespace kinestat
