#include "studies/benchmark/picture/pareto.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace kinestat {

namespace {

// Where an error of zero is drawn: below the smallest other one.
double floor_of(const TradeOff& result) {
  double least = 1.0;
  for (const MethodResult& method : result.methods) {
    const double error = method.worst_error.value_or(0.0);
    least = error > 0.0 ? std::min(least, error) : least;
  }
  return least / 10.0;
}

std::string name_of(const MethodResult& method) {
  const bool is_zero = method.worst_error && *method.worst_error == 0.0;
  return fmt::format("{}{}", words_of(method.method), is_zero ? " (no error)" : "");
}

// By time, so that a line joins neighbours.
Series front_of(const TradeOff& result, double floor) {
  std::vector<std::pair<double, double>> points;
  for (const MethodResult& method : result.methods) {
    if (method.is_on_front && method.worst_error) {
      points.emplace_back(method.time, std::max(*method.worst_error, floor));
    }
  }
  std::ranges::sort(points);
  Series front = {.name = "front"};
  for (const auto& [time, error] : points) {
    front.x.push_back(time);
    front.y.push_back(error);
  }
  return front;
}

// A method looks the same in every chart, also where another has no answer.
Chart chart_of(std::string title, const TradeOff& result) {
  Chart chart = {
      .title = std::move(title),
      .x = {.label = "time, as a multiple of a dense LU in double",
            .unit = "",
            .scale = ScaleKind::logarithmic},
      .y = {.label = "largest relative error", .unit = "", .scale = ScaleKind::logarithmic},
      .series = {}};
  const double floor = floor_of(result);
  chart.series.push_back(front_of(result, floor));
  for (const MethodResult& method : result.methods) {
    if (method.worst_error) {
      chart.series.push_back({.name = name_of(method),
                              .x = {method.time},
                              .y = {std::max(*method.worst_error, floor)},
                              .style = SeriesStyle::points,
                              .look = 1 + static_cast<int>(method.method)});
    }
  }
  return chart;
}

}  // namespace

Figure pareto_figure(const std::string& title, const std::vector<BenchmarkedCase>& cases) {
  Figure figure = {.name = "pareto",
                   .title = title,
                   .description =
                       "Time and largest error of each method of solution on logarithmic "
                       "axes; a line joins those that no other method beats in both.",
                   .charts = {}};
  for (const BenchmarkedCase& one : cases) {
    const std::string label = one.label.empty() ? "" : one.label + ", ";
    if (one.motion.reason == NoProblem::none) {
      figure.charts.push_back(
          chart_of(fmt::format("{}{} velocities", label, one.motion.unknowns), one.motion));
    }
    if (one.action.reason == NoProblem::none) {
      figure.charts.push_back(
          chart_of(fmt::format("{}{} actions", label, one.action.unknowns), one.action));
    }
  }
  return figure;
}

}  // namespace kinestat
