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
#include "studies/motion/picture/motion_abscissa.hpp"
#include "studies/motion/picture/motion_line.hpp"

namespace kinestat {

namespace {

constexpr std::size_t kMostSeries = 6;    // of one chart; more go into the next
constexpr std::size_t kMostMarked = 2;    // series of a chart whose extremes are marked
constexpr std::size_t kMostOfAGuide = 4;  // freedoms that its label names
constexpr const char* kPlace = "at/";

// Rates that nothing determines have none.
bool has_values(const MotionTable& motion, std::size_t column) {
  return std::ranges::any_of(
      motion.rows, [column](const MotionRow& row) { return row.values[column].has_value(); });
}

// Events of one place share a guide, but friction that turns round, where curves jump by
// themselves: "dead point of D, G at 90°". The order is that of the names, for rounding decides
// which of them was found first.
std::vector<ChartGuide> guides_of(const MotionTable& motion, const MotionAbscissa& over) {
  struct Place {
    double x = 0.0;
    std::map<std::string, std::set<std::string>> elements;  // by kinds of events
  };

  std::vector<std::string> order;
  std::map<std::string, Place> places;
  for (const MotionEvent& event : motion.events) {
    const std::optional<double> x = over.place_of(event);
    if (!x || event.kind == kFrictionReversalEvent) {
      continue;
    }
    const std::string where = over.place_text(*x);
    const auto [at, is_new] = places.try_emplace(where, Place{.x = *x, .elements = {}});
    if (is_new) {
      order.push_back(where);
    }
    at->second.elements[quantity_words(event.kind)].insert(event.element);
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
                                    const MotionAbscissa& over,
                                    std::size_t column,
                                    const Series& series,
                                    bool largest) {
  if (column >= motion.figures.size()) {
    return extreme_row(series, largest);
  }
  const ColumnFigures& figures = motion.figures[column];
  const std::optional<ColumnExtreme>& extreme = largest ? figures.greatest : figures.least;
  const std::optional<double> x = extreme ? over.place_of(*extreme) : std::nullopt;
  if (!x || extreme->row == 0.0 || extreme->row == static_cast<double>(series.x.size() - 1)) {
    return std::nullopt;
  }
  return ChartMark{.x = *x, .y = extreme->value, .label = {}};
}

void mark_extremes(const MotionTable& motion,
                   const MotionAbscissa& over,
                   const Group& group,
                   Chart& chart) {
  if (chart.series.size() > kMostMarked) {
    return;
  }
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const Series& series = chart.series[i];
    for (const bool largest : {true, false}) {
      auto mark = extreme_of(motion, over, group.columns[i], series, largest);
      if (mark && has_changes(series.y)) {
        mark->label = largest ? "max" : "min";
        mark->tells_value = true;
        chart.marks.push_back(std::move(*mark));
      }
    }
  }
}

// Whether the column is of a driven freedom, or of a body that turns with it.
bool follows_drive(const MotionTable& motion, const MotionColumn& column, std::size_t at) {
  const std::vector<double> values = column_values(motion, at);
  for (std::size_t d = 0; d < motion.drives.size(); ++d) {
    if (column.element != motion.drives[d].freedom && !column.quantity.starts_with("rotation/")) {
      continue;
    }
    const std::vector<double> drive = column_values(motion, d);
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

// Whether there is a column of the position of the driven freedom, or columns are named one by one.
bool needs_no_drive(const MotionTable& motion, std::size_t drive) {
  return std::ranges::any_of(motion.columns, [&](const MotionColumn& one) {
    return one.is_named ||
           (one.element == motion.drives[drive].freedom && one.quantity == "position");
  });
}

// How well circuits close is rounding, and where the drives are and when is a straight line over a
// drive, or over time where they run steadily: of these there is nothing to see, nor of what is
// always the same. Places are paths.
bool is_left_out(const MotionTable& motion, const MotionAbscissa& over, std::size_t at) {
  const MotionColumn& column = motion.columns[at];
  const std::vector<double> values = column_values(motion, at);
  if (column.quantity.starts_with(kPlace) || column.quantity == kClosureErrorColumn ||
      column.quantity == kTimeColumn || at == over.column() || !has_changes(values)) {
    return true;
  }
  const bool is_drive = column.quantity == kDriveColumn;
  if (!is_drive && !follows_drive(motion, column, at)) {
    return false;
  }
  const bool is_seen_elsewhere =
      is_drive ? needs_no_drive(motion, at) : column.quantity != "position";
  return over.is_drive() || is_seen_elsewhere || runs_straight(values, over.values());
}

std::vector<Group> groups_of(const MotionTable& motion, const MotionAbscissa& over) {
  std::vector<Group> groups;
  for (std::size_t c = 0; c < motion.columns.size(); ++c) {
    const MotionColumn& column = motion.columns[c];
    // Named for being the abscissa, but for the drive, which is that by itself.
    const bool is_abscissa = c == over.column() && c != 0;
    if (is_abscissa || (!column.is_named && is_left_out(motion, over, c)) ||
        !has_values(motion, c)) {
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

// Steps beside a pole may have values far above all others: the frame then shows these, and lines
// leave it.
void cut_beside_poles(Chart& chart) {
  constexpr double kUsual = 0.75;  // of the values lie below it
  constexpr double kFarAbove = 10.0;
  constexpr double kShown = 4.0;
  std::vector<double> sizes;
  double least = 0.0;
  double greatest = 0.0;
  for (const Series& series : chart.series) {
    for (const double value : series.y) {
      if (std::isfinite(value)) {
        sizes.push_back(std::abs(value));
        least = std::min(least, value);
        greatest = std::max(greatest, value);
      }
    }
  }
  const bool has_poles =
      std::ranges::any_of(chart.series, [](const Series& one) { return !one.breaks.empty(); });
  if (!has_poles || sizes.empty()) {
    return;
  }
  std::ranges::sort(sizes);
  const double usual = sizes[static_cast<std::size_t>(kUsual * static_cast<double>(sizes.size()))];
  if (usual > 0.0 && sizes.back() > kFarAbove * usual) {
    chart.y.low = std::max(least, -kShown * usual);
    chart.y.high = std::min(greatest, kShown * usual);
  }
}

Chart chart_of(const Group& group, const MotionTable& motion, const MotionAbscissa& over) {
  Chart chart = {.x = over.axis(),
                 .y = {.label = quantity_words(group.quantity), .unit = group.unit},
                 .series = {}};
  for (const std::size_t c : group.columns) {
    chart.series.push_back(motion_line(motion, over, c));
  }
  if (chart.series.size() == 1 && !chart.series.front().name.empty()) {
    chart.y.label += " of " + chart.series.front().name;
  }
  cut_beside_poles(chart);
  chart.guides = guides_of(motion, over);
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
    const MotionAbscissa over(motion, place.x);
    Series series = motion_line(motion, over, place.*vertical);
    // A point that rests has no path.
    if (has_changes(series.x) || has_changes(series.y)) {
      chart.series.push_back(std::move(series));
    }
  }
  if (chart.series.size() > 1) {
    chart.title = fmt::format("{} over x", up);
  }
  for (const Series& series : chart.series) {
    if (chart.series.size() <= kMostMarked) {
      chart.marks.push_back({.x = series.x.front(), .y = series.y.front(), .label = "start"});
    }
  }
  if (chart.series.size() == 1) {
    chart.title = chart.series.front().name;
  }
  return chart;
}

bool changes_height(const MotionTable& motion) {
  return std::ranges::any_of(places_of(motion), [&motion](const PlaceColumns& place) {
    return place.z < motion.columns.size() && has_changes(column_values(motion, place.z));
  });
}

}  // namespace

Figure motion_figure(const MotionTable& motion,
                     const std::string& title,
                     std::optional<std::size_t> column) {
  Figure figure = {.name = "motion-curves",
                   .title = title,
                   .description =
                       "What the positions of the motion have, against one of its columns; dead "
                       "points and limits are marked.",
                   .charts = {}};
  if (motion.rows.empty() || motion.columns.empty()) {
    return figure;
  }
  const MotionAbscissa over(motion, column.value_or(usual_abscissa(motion)));
  figure.description = fmt::format(
      "What the positions of the motion have, against the {}; dead points and limits are marked.",
      over.axis().label);
  for (const Group& group : groups_of(motion, over)) {
    figure.charts.push_back(chart_of(group, motion, over));
    for (ChartGuide& guide : figure.charts.back().guides) {
      guide.is_named = figure.charts.size() == 1;
    }
    mark_extremes(motion, over, group, figure.charts.back());
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
