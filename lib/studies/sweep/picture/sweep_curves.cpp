#include "studies/sweep/picture/sweep_curves.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace kinestat {

namespace {

constexpr std::size_t kMostCurves = 6;  // of one chart

// "h [m]" as name and unit.
ChartAxis axis_of(const std::string& title) {
  const std::size_t unit = title.find(" [");
  return {.label = title.substr(0, unit),
          .unit = unit == std::string::npos ? "" : title.substr(unit + 2, title.size() - unit - 3)};
}

// The parameter with the most values, the first of several.
std::size_t longest_axis(const SweepTable& sweep) {
  std::size_t best = 0;
  std::size_t most = 0;
  for (std::size_t i = 0; i < sweep.varied.size(); ++i) {
    std::set<double> values;
    for (const SweepTableRow& row : sweep.rows) {
      values.insert(row.places[i]);
    }
    if (values.size() > most) {
      most = values.size();
      best = i;
    }
  }
  return most > 1 ? best : sweep.varied.size();
}

// A series of a chart: the rows of one case with the same values of all other parameters, or of a
// sample all rows of one case.
struct Line {
  std::string name;
  std::vector<const SweepTableRow*> rows;
};

std::string name_of(const SweepTable& sweep, const SweepTableRow& row, std::size_t along) {
  std::string name = row.label;
  for (std::size_t i = 0; i < sweep.varied.size() && !sweep.is_sample; ++i) {
    if (i != along) {
      const ChartAxis axis = axis_of(sweep.varied[i]);
      name += fmt::format("{}{} {}{}{}",
                          name.empty() ? "" : ", ",
                          axis.label,
                          label_number(row.places[i], 4),
                          axis.unit.empty() ? "" : " ",
                          axis.unit);
    }
  }
  return name;
}

// In the order of the rows.
std::vector<Line> lines_of(const SweepTable& sweep, std::size_t along) {
  std::vector<Line> lines;
  std::map<std::pair<std::string, std::vector<double>>, std::size_t> known;
  for (const SweepTableRow& row : sweep.rows) {
    std::vector<double> others;
    if (!sweep.is_sample) {
      others = row.places;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(along));
    }
    const auto [at, is_new] = known.try_emplace({row.label, std::move(others)}, lines.size());
    if (is_new) {
      lines.push_back({.name = name_of(sweep, row, along), .rows = {}});
    }
    lines[at->second].rows.push_back(&row);
  }
  for (Line& line : lines) {
    std::ranges::stable_sort(line.rows, [along](const auto* one, const auto* other) {
      return one->places[along] < other->places[along];
    });
  }
  return lines;
}

Series series_of(const Line& line, SeriesStyle style, std::size_t along, std::size_t quantity) {
  Series series{.name = line.name, .style = style};
  for (const SweepTableRow* row : line.rows) {
    series.x.push_back(row->places[along]);
    series.y.push_back(row->values[quantity]);
  }
  return series;
}

// The value that all points have, if there is one.
std::optional<double> only_value(const Chart& chart) {
  std::optional<double> only;
  for (const Series& series : chart.series) {
    for (const double value : series.y) {
      if (value != only.value_or(value)) {
        return std::nullopt;
      }
      only = value;
    }
  }
  return only;
}

std::string describe(const SweepTable& sweep, std::size_t along, std::size_t lines) {
  const std::string over = axis_of(sweep.varied[along]).label;
  const std::string shown =
      lines > kMostCurves ? fmt::format("; {} of {} curves are shown", kMostCurves, lines) : "";
  return fmt::format("{} states of the sweep, over {}{}.", sweep.states, over, shown);
}

// Of all lines some at equal distances, the first and the last among them.
std::vector<const Line*> shown_lines(const std::vector<Line>& lines) {
  std::vector<const Line*> shown;
  const std::size_t count = std::min(lines.size(), kMostCurves);
  for (std::size_t i = 0; i < count; ++i) {
    shown.push_back(&lines[count == 1 ? 0 : i * (lines.size() - 1) / (count - 1)]);
  }
  return shown;
}

}  // namespace

std::string why_no_curves_of_sweep(const SweepTable& sweep) {
  if (sweep.states > kMostSweptStates) {
    return fmt::format(
        "its sweep has {} states, and curves are drawn of up to {}; {}, or take the rows that "
        "'kinestat sweep' writes",
        sweep.states,
        kMostSweptStates,
        sweep.is_sample ? "draw fewer" : "vary less or in larger steps");
  }
  if (sweep.rows.empty()) {
    return fmt::format("the conditions of its sweep leave no row of its {} states; ask for less",
                       sweep.states);
  }
  const bool has_value = std::ranges::any_of(sweep.rows, [](const SweepTableRow& row) {
    return !std::ranges::all_of(row.values, [](double value) { return std::isnan(value); });
  });
  if (!has_value) {
    return "no state of its sweep has an answer";
  }
  return longest_axis(sweep) == sweep.varied.size()
             ? "its sweep has no parameter with two values; vary one, or take the rows that "
               "'kinestat sweep' writes"
             : "";
}

Figure sweep_figure(const SweepTable& sweep, const std::string& title) {
  Figure figure = {.name = "sweep-curves", .title = title, .description = "", .charts = {}};
  const std::size_t along = longest_axis(sweep);
  if (along == sweep.varied.size()) {
    return figure;
  }
  const std::vector<Line> lines = lines_of(sweep, along);
  const SeriesStyle style = sweep.is_sample ? SeriesStyle::points : SeriesStyle::line;
  figure.description = describe(sweep, along, lines.size());
  for (std::size_t q = 0; q < sweep.quantities.size(); ++q) {
    Chart chart = {
        .x = axis_of(sweep.varied[along]), .y = axis_of(sweep.quantities[q]), .series = {}};
    for (const Line* line : shown_lines(lines)) {
      chart.series.push_back(series_of(*line, style, along, q));
    }
    figure.charts.push_back(std::move(chart));
  }
  // A line at one height is said rather than drawn, beside others.
  if (!std::ranges::all_of(figure.charts,
                           [](const Chart& one) { return only_value(one).has_value(); })) {
    std::erase_if(figure.charts, [&figure](const Chart& chart) {
      const std::optional<double> only = only_value(chart);
      if (only) {
        figure.description +=
            fmt::format(" {} is {} throughout.", axis_title(chart.y, 0), label_number(*only));
      }
      return only.has_value();
    });
  }
  return figure;
}

}  // namespace kinestat
