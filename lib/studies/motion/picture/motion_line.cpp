#include "studies/motion/picture/motion_line.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "core/motion_tolerance.hpp"

namespace kinestat {

namespace {

struct PlacedPoint {
  double row = 0.0;
  PointBetween point;
};

class MotionLine {
 public:
  MotionLine(const MotionTable& motion, const MotionAbscissa& over, std::size_t column)
      : motion_(motion), over_(over), column_(column) {}

  Series run() {
    Series line = {.name = motion_.columns[column_].element,
                   .x = over_.values(),
                   .y = column_values(motion_, column_)};
    const FiniteRange ends = range_of(line.y);
    range_ = ends.high - ends.low;
    for (const MotionPlace& place : motion_.places) {
      add(over_.place_of(place), place.values[column_], place.row);
    }
    for (const MotionEvent& event : motion_.events) {
      const bool has_places = column_ < event.places.size() && event.row >= 0.0;
      add_unless_there(
          over_.place_of(event), has_places ? event.places[column_] : std::nullopt, event.row);
    }
    if (column_ < motion_.figures.size()) {
      const ColumnFigures& figures = motion_.figures[column_];
      line.breaks = figures.poles;
      for (const std::optional<ColumnExtreme>& one : {figures.least, figures.greatest}) {
        if (one && over_.knows_places_of_extremes() && one->row >= 0.0) {
          add_unless_there(over_.place_of(*one), one->value, one->row);
        }
      }
    }
    std::ranges::stable_sort(points_, {}, &PlacedPoint::row);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      // On which side of a pole it is, nobody knows.
      const PointBetween& one = points_[i].point;
      if (one.before == 0 || one.before >= line.x.size() ||
          std::ranges::binary_search(line.breaks, one.before)) {
        continue;
      }
      if (i > 0 && points_[i - 1].point.before == one.before &&
          points_[i].row - points_[i - 1].row < kSameApproach && !is_gap(one) &&
          !is_gap(points_[i - 1].point)) {
        if (!jumps(points_[i - 1].point.y, one.y)) {
          continue;
        }
        line.between.push_back(gap_at(one));
      }
      line.between.push_back(one);
    }
    return line;
  }

 private:
  // What stands at a row and has its value says no more than the row; the line is broken between
  // that value and another one.
  void add(const std::optional<double>& x, const std::optional<double>& y, double row) {
    const double nearest = std::round(row);
    const auto at = static_cast<std::size_t>(nearest);
    const bool is_at_row = std::abs(row - nearest) < kSameApproach && at < motion_.rows.size();
    if (!x || (!y && is_at_row)) {
      return;
    }
    if (!y) {  // as in a dwell within a step, in which friction has no direction
      const auto before = static_cast<std::size_t>(std::ceil(row));
      points_.push_back({.row = row, .point = gap_at({.before = before, .x = *x, .y = 0.0})});
    } else if (!is_at_row) {
      add(row, static_cast<std::size_t>(std::ceil(row)), *x, *y);
    } else if (const std::optional<double>& there = motion_.rows[at].values[column_]; !there) {
      if (row <= nearest) {
        add(row, at, *x, *y);
      }
      if (row >= nearest) {
        add(row, at + 1, *x, *y);
      }
    } else if (jumps(*there, *y)) {
      const bool is_before = row <= nearest;
      const PointBetween side = {.before = is_before ? at : at + 1, .x = *x, .y = *y};
      points_.push_back({.row = row, .point = is_before ? side : gap_at(side)});
      points_.push_back({.row = row, .point = is_before ? gap_at(side) : side});
    }
  }

  void add(double row, std::size_t before, double x, double y) {
    points_.push_back({.row = row, .point = {.before = before, .x = x, .y = y}});
  }

  void add_unless_there(const std::optional<double>& x,
                        const std::optional<double>& y,
                        double row) {
    const auto is_there = [row](const PlacedPoint& one) {
      return std::abs(one.row - row) < kSameApproach;
    };
    if (y && std::ranges::none_of(points_, is_there)) {
      add(x, y, row);
    }
  }

  bool jumps(double from, double to) const { return std::abs(to - from) > kJump * range_; }

  static bool is_gap(const PointBetween& one) { return std::isnan(one.y); }

  static PointBetween gap_at(const PointBetween& one) {
    return {.before = one.before, .x = one.x, .y = std::numeric_limits<double>::quiet_NaN()};
  }

  const MotionTable& motion_;
  const MotionAbscissa& over_;
  std::size_t column_;
  double range_ = 0.0;  // of the rows
  std::vector<PlacedPoint> points_;
};

}  // namespace

Series motion_line(const MotionTable& motion, const MotionAbscissa& over, std::size_t column) {
  return MotionLine(motion, over, column).run();
}

}  // namespace kinestat
