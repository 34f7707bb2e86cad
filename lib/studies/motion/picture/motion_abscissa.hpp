// Over what the charts of a motion stand.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "draw/chart.hpp"
#include "studies/motion/report/motion_time.hpp"

namespace kinestat {

/// "transmission_angle", "linear/x", "lossy_power" in words.
std::string quantity_words(std::string quantity);

/// The time, if the motion has one in which its first drive does not run steadily, as where it
/// dwells or comes back; else the position of that drive.
std::size_t usual_abscissa(const MotionTable& motion);

/// The column of that name, in which a point may replace the slash; of a drive its name will do.
std::optional<std::size_t> find_abscissa(const MotionTable& motion, std::string_view name);

/// A column of a motion as the horizontal axis of charts.
class MotionAbscissa {
 public:
  MotionAbscissa(const MotionTable& motion, std::size_t column)
      : motion_(motion), column_(column), values_(column_values(motion, column)) {}

  std::size_t column() const { return column_; }

  const std::vector<double>& values() const { return values_; }

  bool is_drive() const;

  /// From end to end of the motion.
  ChartAxis axis() const;

  /// "90°", "0.25": a value of it in a label.
  std::string place_text(double value) const;

  /// Where it stands: on the straight line from row to row, where it has no value of its own. Empty
  /// before the first row, and where the rows have none.
  std::optional<double> place_of(const MotionEvent& event) const;
  std::optional<double> place_of(const ColumnExtreme& extreme) const;

  std::optional<double> place_of(const MotionPlace& place) const { return place.values[column_]; }

  /// Whether place_of of an extreme is more than that straight line.
  bool knows_places_of_extremes() const { return column_ == 0 || is_time(); }

 private:
  bool is_time() const { return motion_.columns[column_].quantity == kTimeColumn; }

  std::optional<double> between_rows(double row) const;

  const MotionTable& motion_;
  std::size_t column_;
  std::vector<double> values_;
};

}  // namespace kinestat
