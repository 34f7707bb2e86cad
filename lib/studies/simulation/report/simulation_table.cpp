#include "studies/simulation/report/simulation_table.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "core/motion_tolerance.hpp"

namespace kinestat {

namespace {

// Where that is between the rows.
double row_at(const std::vector<SimulationRow>& rows, double time) {
  const auto behind = std::ranges::upper_bound(rows, time, {}, &SimulationRow::time);
  if (behind == rows.begin() || behind == rows.end()) {
    return behind == rows.begin() ? 0.0 : static_cast<double>(rows.size() - 1);
  }
  const double before = std::prev(behind)->time;
  return static_cast<double>(behind - rows.begin() - 1) + (time - before) / (behind->time - before);
}

std::optional<ColumnExtreme> placed(const std::optional<SimulationExtreme>& extreme,
                                    const SimulationColumn& column,
                                    const SimulationReportView& view) {
  if (!extreme) {
    return std::nullopt;
  }
  const FileUnits& units = view.description.units;
  return ColumnExtreme{.value = units.from_si(column.kind, extreme->value),
                       .drive = units.from_si(QuantityKind::time, extreme->time),
                       .row = row_at(view.solution.rows, extreme->time)};
}

// With what the columns come to from either side.
MotionEvent placed(const SimulationEvent& event,
                   const std::vector<SimulationColumn>& columns,
                   const SimulationReportView& view) {
  const FileUnits& units = view.description.units;
  const std::vector<SimulationSides>& sides = view.solution.sides;
  MotionEvent placed{.kind = std::string(word_of(event.kind)),
                     .element = event.element,
                     .step = 0,
                     .drive = {units.from_si(QuantityKind::time, event.time)},
                     .uncertainty = 0.0,
                     .row = row_at(view.solution.rows, event.time),
                     .places = {}};
  const auto of_event = std::ranges::lower_bound(sides, event.time, {}, &SimulationSides::time);
  if (of_event == sides.end() || of_event->time != event.time) {
    return placed;
  }
  // Of several at one time the first is left, and the last arrived at.
  const auto behind = std::ranges::upper_bound(sides, event.time, {}, &SimulationSides::time);
  const auto in_unit = [&](const std::optional<double>& si, QuantityKind kind) {
    return si ? std::optional(units.from_si(kind, *si)) : std::nullopt;
  };
  for (const SimulationColumn& column : columns) {
    placed.before.push_back(in_unit(of_event->before[column.reading], column.kind));
    placed.after.push_back(in_unit(std::prev(behind)->after[column.reading], column.kind));
  }
  return placed;
}

// Through which lines are led to a jump, and from it.
void add_sides(const MotionEvent& event, std::vector<MotionPlace>& places) {
  const auto add = [&](const std::vector<std::optional<double>>& side, double beside) {
    if (!side.empty()) {
      places.push_back({.row = event.row + beside, .values = side});
      places.back().values.front() = event.drive.front();  // the time
    }
  };
  add(event.before, -kApproach);
  add(event.after, kApproach);
}

}  // namespace

MotionTable simulation_table(const SimulationReportView& view) {
  const FileUnits& units = view.description.units;
  const SimulationSolution& solution = view.solution;
  const auto in_time = [&](double si) { return units.from_si(QuantityKind::time, si); };
  MotionTable table;
  table.time_unit = units.text(QuantityKind::time);
  const double end = solution.rows.empty() ? 0.0 : solution.rows.back().time;
  table.drives.push_back({.name = std::string(kTimeColumn),
                          .freedom = {},
                          .unit = table.time_unit,
                          .from = 0.0,
                          .to = in_time(view.plan.duration),
                          .reached = in_time(end)});
  table.rows.resize(solution.rows.size());
  const std::vector<SimulationColumn> columns = simulation_columns(view);
  for (const SimulationColumn& column : columns) {
    table.columns.push_back(
        {.element = column.element, .quantity = column.quantity, .unit = units.text(column.kind)});
    const SimulationExtremes extremes = column.extremes.value_or(SimulationExtremes{});
    table.figures.push_back({.least = placed(extremes.least, column, view),
                             .greatest = placed(extremes.greatest, column, view),
                             .mean = {},
                             .rms = {}});
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
      const std::optional<double>& value = column.values[r];
      table.rows[r].step = static_cast<int>(r);
      table.rows[r].values.push_back(value ? std::optional(units.from_si(column.kind, *value))
                                           : std::nullopt);
    }
  }
  for (const SimulationEvent& one : solution.events) {
    table.events.push_back(placed(one, columns, view));
    add_sides(table.events.back(), table.places);
  }
  std::ranges::stable_sort(table.places, {}, &MotionPlace::row);
  return table;
}

}  // namespace kinestat
