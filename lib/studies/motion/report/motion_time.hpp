// When something happens in a motion, and over what its values are best shown.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "studies/motion/report/motion_table.hpp"

namespace kinestat {

/// The values of a column in each row; not a number where it has none.
std::vector<double> column_values(const MotionTable& motion, std::size_t column);

/// From the least finite value to the greatest; the other way round without any.
struct FiniteRange {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

FiniteRange range_of(const std::vector<double>& values);

/// Whether there are different values, and not by rounding alone.
bool has_changes(const std::vector<double>& values);

/// Whether the values lie on one straight line over others, of which there are as many.
bool runs_straight(const std::vector<double>& values, const std::vector<double>& over);

/// On the straight line from row to row. Empty before the first row, and where the rows have none.
std::optional<double> value_at_row(const MotionTable& motion, std::size_t column, double row);

/// The column of the time of a motion in time.
std::optional<std::size_t> time_column(const MotionTable& motion);

/// When a row is, or what lies between two of them, in the unit of time; empty of a motion without
/// time.
std::optional<double> time_at_row(const MotionTable& motion, double row);

/// Whether a motion in time has a first drive that dwells or comes back, so that its position does
/// not say when something happens.
bool is_told_by_time(const MotionTable& motion);

/// Whether a motion in time is best drawn over it: where its first drive does not run steadily.
bool is_drawn_over_time(const MotionTable& motion);

}  // namespace kinestat
