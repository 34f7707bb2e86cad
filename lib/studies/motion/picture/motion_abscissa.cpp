#include "studies/motion/picture/motion_abscissa.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/tolerance.hpp"
#include "draw/axes.hpp"
#include "mechanism/column_path.hpp"

namespace kinestat {

std::string quantity_words(std::string quantity) {
  struct Key {
    std::string_view head;
    const char* before;
    const char* behind;
  };

  constexpr std::array kKeys = {Key{"linear/", "velocity ", ""},
                                Key{"angular/", "angular velocity ", ""},
                                Key{"lossy_", "", " with mesh losses"},
                                Key{"bias_", "", " at constant speed"}};
  if (quantity == kDriveColumn) {
    return "position";
  }
  for (const Key& one : kKeys) {
    if (quantity.starts_with(one.head)) {
      quantity = one.before + quantity.substr(one.head.size()) + one.behind;
    }
  }
  std::ranges::replace(quantity, '_', ' ');
  std::ranges::replace(quantity, '/', ' ');
  return quantity;
}

std::size_t usual_abscissa(const MotionTable& motion) {
  const auto time = time_column(motion);
  return time && !motion.columns[*time].is_named && is_drawn_over_time(motion) ? *time : 0;
}

std::optional<std::size_t> find_abscissa(const MotionTable& motion, std::string_view name) {
  const std::string asked = dotted(std::string(name));
  for (std::size_t c = 0; c < motion.columns.size(); ++c) {
    const MotionColumn& column = motion.columns[c];
    const bool is_drive_of_name = column.quantity == kDriveColumn && column.element == name;
    if (is_drive_of_name || dotted(column.name()) == asked) {
      return c;
    }
  }
  return std::nullopt;
}

bool MotionAbscissa::is_drive() const {
  return motion_.columns[column_].quantity == kDriveColumn;
}

ChartAxis MotionAbscissa::axis() const {
  const MotionColumn& column = motion_.columns[column_];
  const std::string words = quantity_words(column.quantity);
  ChartAxis axis = {.label = column.element.empty() ? words : words + " of " + column.element,
                    .unit = column.unit};
  const FiniteRange ends = range_of(values_);
  if (ends.low < ends.high) {
    axis.low = ends.low;
    axis.high = ends.high;
  }
  return axis;
}

std::string MotionAbscissa::place_text(double value) const {
  return label_number(value, 5) + (motion_.columns[column_].unit == "deg" ? "°" : "");
}

std::optional<double> MotionAbscissa::place_of(const MotionEvent& event) const {
  if (column_ < event.drive.size()) {
    return std::isfinite(event.drive[column_]) ? std::optional(event.drive[column_]) : std::nullopt;
  }
  if (column_ < event.places.size() && event.places[column_]) {
    return event.places[column_];
  }
  const MotionColumn& column = motion_.columns[column_];
  if (event.kind == kDeadPointEvent && column.element == event.element &&
      column.quantity == "velocity") {
    return 0.0;
  }
  return is_time() ? between_rows(event.row) : std::nullopt;
}

std::optional<double> MotionAbscissa::place_of(const ColumnExtreme& extreme) const {
  return column_ == 0 ? std::optional(extreme.drive) : between_rows(extreme.row);
}

std::optional<double> MotionAbscissa::between_rows(double row) const {
  return value_at_row(motion_, column_, row);
}

}  // namespace kinestat
