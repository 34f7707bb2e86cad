#include "studies/motion/picture/motion_curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/tolerance.hpp"

namespace kinestat {

namespace {

constexpr std::size_t kMostSeries = 6;    // of one chart; more go into the next
constexpr std::size_t kMostMarked = 2;    // series of a chart whose extremes are marked
constexpr std::size_t kMostOfAGuide = 4;  // freedoms that its label names
constexpr const char* kPlace = "at/";

std::vector<double> values_of(const MotionTable& motion, std::size_t column) {
  std::vector<double> values;
  for (const MotionRow& row : motion.rows) {
    values.push_back(row.values[column].value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  return values;
}

// Rates that nothing determines have none.
bool has_values(const MotionTable& motion, std::size_t column) {
  return std::ranges::any_of(
      motion.rows, [column](const MotionRow& row) { return row.values[column].has_value(); });
}

// Whether there are different values, and not by rounding alone.
bool changes(const std::vector<double>& values) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const double value : values) {
    if (std::isfinite(value)) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  return high - low > kSameValue * std::max(std::abs(low), std::abs(high));
}

// "transmission_angle", "linear/x", "lossy_power" in words.
std::string words_of(std::string quantity) {
  struct Key {
    std::string_view head;
    const char* before;
    const char* behind;
  };

  constexpr std::array kKeys = {Key{"linear/", "velocity ", ""},
                                Key{"angular/", "angular velocity ", ""},
                                Key{"lossy_", "", " with mesh losses"},
                                Key{"bias_", "", " at constant speed"}};
  for (const Key& one : kKeys) {
    if (quantity.starts_with(one.head)) {
      quantity = one.before + quantity.substr(one.head.size()) + one.behind;
    }
  }
  std::ranges::replace(quantity, '_', ' ');
  std::ranges::replace(quantity, '/', ' ');
  return quantity;
}

// "90°", as the label of an event says where it is.
std::string place_of_event(const MotionEvent& event, const std::string& unit) {
  return label_number(event.drive.front(), 5) + (unit == "deg" ? "°" : "");
}

// Events of one place share a guide: "dead point of D, G at 90°". The order is that of the names,
// for rounding decides which of them was found first.
std::vector<ChartGuide> guides_of(const MotionTable& motion) {
  struct Place {
    double x = 0.0;
    std::map<std::string, std::set<std::string>> elements;  // by kinds of events
  };

  std::vector<std::string> order;
  std::map<std::string, Place> places;
  for (const MotionEvent& event : motion.events) {
    if (event.drive.empty() || !std::isfinite(event.drive.front())) {
      continue;
    }
    const std::string where = place_of_event(event, motion.columns.front().unit);
    const auto [at, is_new] =
        places.try_emplace(where, Place{.x = event.drive.front(), .elements = {}});
    if (is_new) {
      order.push_back(where);
    }
    at->second.elements[words_of(event.kind)].insert(event.element);
  }
  std::vector<ChartGuide> guides;
  for (const std::string& where : order) {
    const Place& place = places.at(where);
    std::string label;
    for (const auto& [kind, elements] : place.elements) {
      std::vector<std::string> named(elements.begin(), elements.end());
      std::erase(named, "");
      label += (label.empty() ? "" : ", ") + kind + (named.empty() ? "" : " of ") +
               plain_list(named, kMostOfAGuide);
    }
    guides.push_back({.x = place.x, .label = fmt::format("{} at {}", label, where)});
  }
  return guides;
}

// Columns that belong into one chart.
struct Group {
  std::string quantity;
  std::string unit;
  std::vector<std::size_t> columns;
};

// The largest or smallest value of a series where it is no end of it.
std::optional<ChartMark> extreme_row(const Series& series, bool largest) {
  std::size_t best = series.y.size();
  for (std::size_t i = 0; i < series.y.size(); ++i) {
    const bool is_better = best == series.y.size() ||
                           (largest ? series.y[i] > series.y[best] : series.y[i] < series.y[best]);
    if (std::isfinite(series.y[i]) && is_better) {
      best = i;
    }
  }
  if (best == 0 || best + 1 >= series.y.size()) {
    return std::nullopt;
  }
  return ChartMark{.x = series.x[best], .y = series.y[best], .label = {}};
}

// That of the figures, which may lie between the rows.
std::optional<ChartMark> extreme_of(const MotionTable& motion,
                                    std::size_t column,
                                    const Series& series,
                                    bool largest) {
  if (column >= motion.figures.size()) {
    return extreme_row(series, largest);
  }
  const ColumnFigures& figures = motion.figures[column];
  const std::optional<ColumnExtreme>& extreme = largest ? figures.greatest : figures.least;
  if (!extreme || extreme->drive == series.x.front() || extreme->drive == series.x.back()) {
    return std::nullopt;
  }
  return ChartMark{.x = extreme->drive, .y = extreme->value, .label = {}};
}

void mark_extremes(const MotionTable& motion, const Group& group, Chart& chart) {
  if (chart.series.size() > kMostMarked) {
    return;
  }
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const Series& series = chart.series[i];
    for (const bool largest : {true, false}) {
      auto mark = extreme_of(motion, group.columns[i], series, largest);
      if (mark && changes(series.y)) {
        mark->label = largest ? "max" : "min";
        mark->tells_value = true;
        mark->on = i;
        chart.marks.push_back(std::move(*mark));
      }
    }
  }
}

// Whether the column is of a driven freedom, or of a body that turns with it.
bool follows_drive(const MotionTable& motion, const MotionColumn& column, std::size_t at) {
  const std::vector<double> values = values_of(motion, at);
  for (std::size_t d = 0; d < motion.drives.size(); ++d) {
    if (column.element != motion.drives[d].freedom && !column.quantity.starts_with("rotation/")) {
      continue;
    }
    const std::vector<double> drive = values_of(motion, d);
    double largest = 0.0;
    double apart = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      largest = std::max(largest, std::abs(drive[i]));
      apart = std::isfinite(values[i]) ? std::max(apart, std::abs(values[i] - drive[i]))
                                       : std::numeric_limits<double>::infinity();
    }
    if (column.unit == motion.columns[d].unit && apart <= kSameValue * largest) {
      return true;
    }
  }
  return false;
}

// How well circuits close is rounding, and where the drives are and when a straight line: of these
// there is nothing to see, nor of what is always the same. Places are paths.
bool is_left_out(const MotionTable& motion, const MotionColumn& column, std::size_t at) {
  return column.quantity.starts_with(kPlace) || column.quantity == kClosureErrorColumn ||
         column.quantity == kTimeColumn || column.quantity == kDriveColumn ||
         !changes(values_of(motion, at)) || follows_drive(motion, column, at);
}

std::vector<Group> groups_of(const MotionTable& motion) {
  std::vector<Group> groups;
  for (std::size_t c = 0; c < motion.columns.size(); ++c) {
    const MotionColumn& column = motion.columns[c];
    if ((!column.is_named && is_left_out(motion, column, c)) || !has_values(motion, c)) {
      continue;
    }
    const auto at = std::ranges::find_if(groups, [&column](const Group& group) {
      return group.quantity == column.quantity && group.unit == column.unit &&
             group.columns.size() < kMostSeries;
    });
    if (at == groups.end()) {
      groups.push_back({.quantity = column.quantity, .unit = column.unit, .columns = {c}});
    } else {
      at->columns.push_back(c);
    }
  }
  return groups;
}

// From end to end of the motion.
ChartAxis drive_axis(const MotionTable& motion) {
  const MotionColumn& drive = motion.columns.front();
  ChartAxis axis = {
      .label = drive.element.empty() ? drive.quantity : "position of " + drive.element,
      .unit = drive.unit};
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const double value : values_of(motion, 0)) {
    if (std::isfinite(value)) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  if (low < high) {
    axis.low = low;
    axis.high = high;
  }
  return axis;
}

Chart chart_of(const Group& group, const MotionTable& motion) {
  Chart chart = {.x = drive_axis(motion),
                 .y = {.label = words_of(group.quantity), .unit = group.unit},
                 .series = {}};
  for (const std::size_t c : group.columns) {
    chart.series.push_back(
        {.name = motion.columns[c].element, .x = values_of(motion, 0), .y = values_of(motion, c)});
    if (c < motion.figures.size()) {
      chart.series.back().breaks = motion.figures[c].poles;
    }
  }
  if (chart.series.size() == 1 && !chart.series.front().name.empty()) {
    chart.y.label += " of " + chart.series.front().name;
  }
  chart.guides = guides_of(motion);
  return chart;
}

// The columns of the places of a point; as many as there are columns where there is none.
struct PlaceColumns {
  std::string element;
  std::size_t x = 0;
  std::size_t y = 0;
  std::size_t z = 0;
};

std::vector<PlaceColumns> places_of(const MotionTable& motion) {
  std::vector<PlaceColumns> places;
  const std::size_t none = motion.columns.size();
  for (std::size_t c = 0; c < none; ++c) {
    const MotionColumn& column = motion.columns[c];
    if (!column.quantity.starts_with(kPlace)) {
      continue;
    }
    if (places.empty() || places.back().element != column.element) {
      places.push_back({.element = column.element, .x = none, .y = none, .z = none});
    }
    const char axis = column.quantity.back();
    (axis == 'x' ? places.back().x : axis == 'y' ? places.back().y : places.back().z) = c;
  }
  // Points of bodies are numbered, "coupler.1"; the places of bodies themselves come second.
  const auto is_traced = [](const PlaceColumns& one) {
    return one.element.find('.') != std::string::npos;
  };
  if (std::ranges::any_of(places, is_traced)) {
    places.erase(
        std::remove_if(
            places.begin(), places.end(), [&](const PlaceColumns& one) { return !is_traced(one); }),
        places.end());
  }
  return places;
}

Chart path_chart(const MotionTable& motion, char up, std::size_t PlaceColumns::*vertical) {
  Chart chart = {.x = {.label = "x", .unit = motion.length_unit},
                 .y = {.label = std::string(1, up), .unit = motion.length_unit},
                 .series = {},
                 .has_equal_scales = true};
  const std::size_t none = motion.columns.size();
  for (const PlaceColumns& place : places_of(motion)) {
    if (place.x == none || place.*vertical == none) {
      continue;
    }
    Series series = {.name = place.element,
                     .x = values_of(motion, place.x),
                     .y = values_of(motion, place.*vertical)};
    // A point that rests has no path.
    if (changes(series.x) || changes(series.y)) {
      chart.series.push_back(std::move(series));
    }
  }
  if (chart.series.size() > 1) {
    chart.title = fmt::format("{} over x", up);
  }
  for (const Series& series : chart.series) {
    if (chart.series.size() <= kMostMarked) {
      chart.marks.push_back({.x = series.x.front(), .y = series.y.front(), .label = "begin"});
    }
  }
  if (chart.series.size() == 1) {
    chart.title = chart.series.front().name;
  }
  return chart;
}

bool changes_height(const MotionTable& motion) {
  return std::ranges::any_of(places_of(motion), [&motion](const PlaceColumns& place) {
    return place.z < motion.columns.size() && changes(values_of(motion, place.z));
  });
}

}  // namespace

Figure motion_figure(const MotionTable& motion, const std::string& title) {
  Figure figure = {.name = "motion-curves",
                   .title = title,
                   .description =
                       "What the positions of the motion have, against the position of "
                       "the drive; dead points and limits are marked.",
                   .charts = {}};
  if (motion.rows.empty() || motion.columns.empty()) {
    return figure;
  }
  for (const Group& group : groups_of(motion)) {
    figure.charts.push_back(chart_of(group, motion));
    for (ChartGuide& guide : figure.charts.back().guides) {
      guide.is_named = figure.charts.size() == 1;
    }
    mark_extremes(motion, group, figure.charts.back());
  }
  return figure;
}

Figure path_figure(const MotionTable& motion, const std::string& title) {
  Figure figure = {.name = "paths",
                   .title = title,
                   .description = "The paths of points during the motion, to scale.",
                   .charts = {}};
  if (motion.rows.empty()) {
    return figure;
  }
  Chart flat = path_chart(motion, 'y', &PlaceColumns::y);
  if (!flat.series.empty()) {
    figure.charts.push_back(std::move(flat));
  }
  if (changes_height(motion)) {
    Chart upright = path_chart(motion, 'z', &PlaceColumns::z);
    if (!upright.series.empty()) {
      figure.charts.push_back(std::move(upright));
    }
  }
  return figure;
}

}  // namespace kinestat
