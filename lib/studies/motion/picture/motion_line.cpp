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
    for (const MotionEvent& event : motion_.events) {
      add(event);
    }
    if (column_ < motion_.figures.size()) {
      const ColumnFigures& figures = motion_.figures[column_];
      line.breaks = figures.poles;
      add(figures.least);
      add(figures.greatest);
    }
    std::ranges::stable_sort(points_, {}, &PlacedPoint::row);
    for (const PlacedPoint& one : points_) {
      // On which side of a pole it is, nobody knows.
      const std::size_t before = one.point.before;
      if (before > 0 && before < line.x.size() &&
          !std::ranges::binary_search(line.breaks, before)) {
        line.between.push_back(one.point);
      }
    }
    return line;
  }

 private:
  static bool is_at(const PlacedPoint& one, double row) {
    return std::abs(one.row - row) < kSameApproach;
  }

  void add(double row, std::size_t before, double x, double y) {
    points_.push_back({.row = row, .point = {.before = before, .x = x, .y = y}});
  }

  void add(const MotionEvent& event) {
    const std::optional<double> x = event.row >= 0.0 ? over_.place_of(event) : std::nullopt;
    // Of events at one place the first has what all come to.
    if (!x || (!points_.empty() && is_at(points_.back(), event.row))) {
      return;
    }
    const std::optional<double> from = event.value_before(column_);
    const std::optional<double> to = event.value_after(column_);
    const auto row = static_cast<std::size_t>(event.row);
    if (event.row == std::floor(event.row)) {
      add_around_row(row, *x, from, to);
    } else if (from && to) {
      add(event.row, row + 1, *x, *from);
      if (std::abs(*to - *from) > kJump * range_) {
        add(event.row, row + 1, *x, std::numeric_limits<double>::quiet_NaN());
      }
      add(event.row, row + 1, *x, *to);
    } else if (from || to) {
      add(event.row, row + 1, *x, from ? *from : *to);
    } else if (column_ < event.places.size() && event.places[column_]) {
      add(event.row, row + 1, *x, *event.places[column_]);
    }
  }

  // A row upon it that has no value of its own is the gap; else the line is broken there beside its
  // value, where a side is another one.
  void add_around_row(std::size_t row,
                      double x,
                      const std::optional<double>& from,
                      const std::optional<double>& to) {
    if (row >= motion_.rows.size()) {
      return;
    }
    const auto at = static_cast<double>(row);
    const std::optional<double>& own = motion_.rows[row].values[column_];
    const auto is_other = [&](const std::optional<double>& side) {
      return side && (!own || std::abs(*side - *own) > kJump * range_);
    };
    if (is_other(from)) {
      add(at, row, x, *from);
      if (own) {
        add(at, row, x, std::numeric_limits<double>::quiet_NaN());
      }
    }
    if (is_other(to)) {
      if (own) {
        add(at, row + 1, x, std::numeric_limits<double>::quiet_NaN());
      }
      add(at, row + 1, x, *to);
    }
  }

  void add(const std::optional<ColumnExtreme>& extreme) {
    if (!extreme || !over_.knows_places_of_extremes() || !(extreme->row >= 0.0)) {
      return;
    }
    const std::optional<double> x = over_.place_of(*extreme);
    const auto is_there = [&](const PlacedPoint& one) { return is_at(one, extreme->row); };
    if (!x || std::ranges::any_of(points_, is_there)) {
      return;
    }
    const auto row = static_cast<std::size_t>(extreme->row);
    if (extreme->row == std::floor(extreme->row)) {
      add_around_row(row, *x, extreme->value, extreme->value);
    } else {
      add(extreme->row, row + 1, *x, extreme->value);
    }
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
