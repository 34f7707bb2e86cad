#include "studies/simulation/picture/simulation_curves.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "studies/motion/picture/motion_curves.hpp"
#include "studies/motion/picture/motion_line.hpp"

namespace kinestat {

namespace {

constexpr std::string_view kEnergy = "energy/";

// What is left unexplained is too small to be seen beside the others.
constexpr std::string_view kUnexplained = "error";

// More events than these crowd a chart, which then has none.
constexpr std::size_t kMostGuides = 4;

}  // namespace

Figure simulation_figure(const MotionTable& simulation, const std::string& title) {
  MotionTable table = simulation;
  for (std::size_t c = table.columns.size(); c-- > 1;) {
    if (!table.columns[c].quantity.starts_with(kEnergy)) {
      continue;
    }
    table.columns.erase(table.columns.begin() + static_cast<std::ptrdiff_t>(c));
    if (c < table.figures.size()) {
      table.figures.erase(table.figures.begin() + static_cast<std::ptrdiff_t>(c));
    }
    const auto erase = [c](std::vector<std::optional<double>>& values) {
      if (c < values.size()) {
        values.erase(values.begin() + static_cast<std::ptrdiff_t>(c));
      }
    };
    for (MotionRow& row : table.rows) {
      erase(row.values);
    }
    for (MotionEvent& event : table.events) {
      erase(event.places);
      erase(event.before);
      erase(event.after);
    }
  }
  Figure figure = motion_figure(table, title);
  if (table.events.size() > kMostGuides) {
    for (Chart& chart : figure.charts) {
      chart.guides.clear();
    }
  }
  figure.name = "simulation";
  figure.description = "What the rows of the simulation have, over time; a few events are marked.";
  return figure;
}

Figure energy_figure(const MotionTable& simulation, const std::string& title) {
  Figure figure = {.name = "energies",
                   .title = title,
                   .description =
                       "Energies of the simulation over time: kinetic, potential of "
                       "weights and springs, supplied and lost.",
                   .charts = {}};
  Chart chart = {.x = {.label = std::string(kTimeColumn), .unit = simulation.time_unit},
                 .y = {.label = "energy", .unit = {}},
                 .series = {}};
  for (std::size_t c = 0; c < simulation.columns.size(); ++c) {
    const MotionColumn& column = simulation.columns[c];
    const bool is_energy = column.quantity.starts_with(kEnergy);
    if (!is_energy || column.quantity.ends_with(kUnexplained)) {
      continue;
    }
    Series series = motion_line(simulation, MotionAbscissa(simulation, 0), c);
    series.name = column.quantity.substr(kEnergy.size());
    chart.y.unit = column.unit;
    chart.series.push_back(std::move(series));
  }
  if (!simulation.rows.empty()) {
    figure.charts.push_back(std::move(chart));
  }
  return figure;
}

}  // namespace kinestat
