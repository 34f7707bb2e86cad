#include "studies/motion/report/motion_time.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/tolerance.hpp"

namespace kinestat {

FiniteRange range_of(const std::vector<double>& values) {
  FiniteRange range;
  for (const double value : values) {
    if (std::isfinite(value)) {
      range.low = std::min(range.low, value);
      range.high = std::max(range.high, value);
    }
  }
  return range;
}

std::vector<double> column_values(const MotionTable& motion, std::size_t column) {
  std::vector<double> values;
  for (const MotionRow& row : motion.rows) {
    values.push_back(row.values[column].value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  return values;
}

bool has_changes(const std::vector<double>& values) {
  const FiniteRange ends = range_of(values);
  return ends.high - ends.low > kSameValue * std::max(std::abs(ends.low), std::abs(ends.high));
}

bool runs_straight(const std::vector<double>& values, const std::vector<double>& over) {
  if (values.empty() || over.front() == over.back()) {
    return false;
  }
  const FiniteRange ends = range_of(values);
  const double least = kSameValue * std::max(std::abs(ends.low), std::abs(ends.high));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double share = (over[i] - over.front()) / (over.back() - over.front());
    if (!(std::abs(values[i] - std::lerp(values.front(), values.back(), share)) <= least)) {
      return false;
    }
  }
  return true;
}

std::optional<double> value_at_row(const MotionTable& motion, std::size_t column, double row) {
  if (row < 0.0 || motion.rows.empty()) {
    return std::nullopt;
  }
  const std::size_t last = motion.rows.size() - 1;
  const auto i = std::min(static_cast<std::size_t>(row), last);
  const std::optional<double>& here = motion.rows[i].values[column];
  const std::optional<double>& next = motion.rows[std::min(i + 1, last)].values[column];
  const double share = row - static_cast<double>(i);
  if (share == 0.0 || !here || !next) {
    return share == 0.0 ? here : std::nullopt;
  }
  return std::lerp(*here, *next, share);
}

std::optional<std::size_t> time_column(const MotionTable& motion) {
  const auto at = std::ranges::find_if(motion.columns, [](const MotionColumn& one) {
    return one.element.empty() && one.quantity == kTimeColumn;
  });
  return at == motion.columns.end()
             ? std::nullopt
             : std::optional(static_cast<std::size_t>(at - motion.columns.begin()));
}

std::optional<double> time_at_row(const MotionTable& motion, double row) {
  const auto time = time_column(motion);
  return time ? value_at_row(motion, *time, row) : std::nullopt;
}

bool is_told_by_time(const MotionTable& motion) {
  const std::vector<double> places = column_values(motion, 0);
  const bool goes_forth =
      std::ranges::adjacent_find(places, std::ranges::greater_equal{}) == places.end();
  const bool goes_back =
      std::ranges::adjacent_find(places, std::ranges::less_equal{}) == places.end();
  return time_column(motion) && !goes_forth && !goes_back;
}

bool is_drawn_over_time(const MotionTable& motion) {
  const auto time = time_column(motion);
  return time && !runs_straight(column_values(motion, 0), column_values(motion, *time));
}

}  // namespace kinestat
