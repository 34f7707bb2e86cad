#include "pages/chart_figure.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "pages/figures.hpp"
#include "report/number_format.hpp"

namespace kinestat {

namespace {

// A value that is not a number is null.
std::string numbers_json(const std::vector<double>& values) {
  std::vector<std::string> texts;
  for (const double value : values) {
    texts.push_back(std::isfinite(value) ? format_short(value) : "null");
  }
  return fmt::format("[{}]", fmt::join(texts, ","));
}

std::string axis_json(const ChartAxis& axis) {
  return fmt::format(
      R"({{"label":{},"unit":{}}})", script_string(axis.label), script_string(axis.unit));
}

bool is_same(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

// Whether all series stand over the same values, which are then written once.
bool share_values(const std::vector<Series>& series) {
  return std::ranges::all_of(series, [&](const Series& one) {
    return std::ranges::equal(one.x, series.front().x, is_same);
  });
}

std::string values_json(const Chart& chart) {
  const bool are_shared = share_values(chart.series);
  std::vector<std::string> series;
  for (const Series& one : chart.series) {
    const std::string own = are_shared ? "" : fmt::format(R"(,"x":{})", numbers_json(one.x));
    series.push_back(fmt::format(
        R"({{"name":{}{},"y":{}}})", script_string(one.name), own, numbers_json(one.y)));
  }
  return fmt::format(
      R"({{"x":{},"y":{},"plane":{},"at":{},)"
      "\n"
      R"("series":[{}]}})",
      axis_json(chart.x),
      axis_json(chart.y),
      chart.has_equal_scales,
      are_shared && !chart.series.empty() ? numbers_json(chart.series.front().x) : "null",
      fmt::join(series, ",\n"));
}

}  // namespace

void add_chart_figure(const Figure& figure, const ChartPlace& place, Html& html) {
  const std::string values = place.id + "-values";
  html.open("figure",
            {{"class", "chart"},
             {"data-picture", figure.name},
             {"data-chart", values},
             {"data-follows", place.follows.empty() ? "none" : place.follows}});
  add_picture(draw_figure(figure), place.id, html);
  add_caption(place.number, place.caption, html);
  html.open("script", {{"type", "application/json"}, {"id", values}});
  html.markup(values_json(figure.charts.front()));
  html.close();
  html.close();
}

}  // namespace kinestat
