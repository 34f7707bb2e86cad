// The stationary ratios among which a search chooses, set by set.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "studies/transmissions/corner_ranges.hpp"
#include "studies/transmissions/transmission_task.hpp"

namespace kinestat {

/// What is left of the values of one set: those from `first` to `last` of its list, or all between
/// `from` and `to`.
struct AxisPart {
  double from = 0.0;
  double to = 0.0;
  std::size_t first = 0;
  std::size_t last = 0;
};

using StationaryPart = std::array<AxisPart, kMostGearSets>;

/// The product of what each set may have.
class StationaryAxes {
 public:
  StationaryAxes(const TransmissionTask& task, const RoleChoice& choice);

  /// Whether all sets have lists of which all values are tried.
  bool is_grid() const { return is_grid_; }

  bool has_list(std::size_t set) const { return !axes_[set]->values.empty(); }

  const std::vector<double>& values(std::size_t set) const { return axes_[set]->values; }

  const ClosedRange& range(std::size_t set) const { return axes_[set]->range; }

  StationaryPart whole() const;

  /// Whether the corners of a part are all of it: lists with two values at most.
  bool is_corners(const StationaryPart& part) const;

  StationaryBox box(const StationaryPart& part) const;

  /// A point amid a part: in thousandths, or of a list.
  StationaryPoint middle(const StationaryPart& part) const;

  /// The value of a range that is nearest in thousandths, or of a list.
  double nearest(std::size_t set, double value) const;

  /// The nearest to one that is a step away, and another than the value itself if there is one.
  double neighbour(std::size_t set, double value, double step) const;

  /// Whether nothing but one point is left.
  bool is_point(const StationaryPart& part) const;

  /// Cuts the axis with the widest range of ratios; false if ranges are too narrow.
  bool halve(const StationaryPart& part, std::array<StationaryPart, 2>& halves) const;

 private:
  AxisPart part_of_list(std::size_t set, std::size_t first, std::size_t last) const;

  std::size_t sets_;
  std::array<const StationaryRatios*, kMostGearSets> axes_{};
  bool is_grid_ = true;
};

}  // namespace kinestat
