#include "studies/simulation/report/simulation_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/index.hpp"
#include "description/simulation_report_words.hpp"
#include "mechanism/label_kind.hpp"
#include "report/column_table.hpp"
#include "report/csv.hpp"
#include "report/number_format.hpp"
#include "report/report_parts.hpp"
#include "report/table.hpp"
#include "studies/motion/report/motion_text.hpp"

namespace kinestat {

namespace {

// The text shows so many rows.
constexpr std::size_t kMostRows = 21;

class SimulationText {
 public:
  explicit SimulationText(const SimulationReportView& view)
      : v_(view), units_(view.description.units), columns_(simulation_columns(view)) {}

  SimulationBlocks run() const {
    SimulationBlocks blocks;
    blocks.end += head();
    if (!v_.solution.events.empty()) {
      blocks.end += events();
    }
    if (!v_.solution.rows.empty()) {
      blocks.extremes = extremes();
      blocks.rows = TextBlocks(rows());
    }
    return blocks;
  }

 private:
  std::string number(QuantityKind kind, double si) const {
    return format_short(units_.from_si(kind, si));
  }

  std::string with_unit(QuantityKind kind, double si) const {
    return number(kind, si) + " " + units_.text(kind);
  }

  // What stands before the time.
  std::string ending() const {
    switch (v_.solution.end) {
      case SimulationEnd::complete:
        return "complete to";
      case SimulationEnd::stuck:
        return "stuck after";
      case SimulationEnd::parted:
        return fmt::format("{} at {} after",
                           word_of(v_.solution.events.back().kind),
                           v_.solution.events.back().element);
      case SimulationEnd::goal:
        break;
    }
    const SimulationEvent& event =
        *std::ranges::find(v_.solution.events, SimulationEvent::Kind::goal, &SimulationEvent::kind);
    const auto distance = [&](const SimulationGoal& goal) {
      return std::abs((goal.is_speed ? event.speed : event.position).value_or(0.0) - goal.value);
    };
    const SimulationGoal* met = nullptr;
    for (const SimulationGoal& goal : v_.plan.goals) {
      if (goal.of.name == event.element && (met == nullptr || distance(goal) < distance(*met))) {
        met = &goal;
      }
    }
    KINESTAT_EXPECTS(met != nullptr);
    const QuantityKind kind =
        met->is_speed ? rate_kind(event.is_rotation) : position_kind(event.is_rotation);
    return fmt::format("{} reached {} after", event.element, with_unit(kind, met->value));
  }

  std::string head() const {
    const SimulationSolution& one = v_.solution;
    const double time = one.rows.empty() ? 0.0 : one.rows.back().time;
    std::string text =
        fmt::format("Simulation: {} {}\n", ending(), with_unit(QuantityKind::time, time));
    std::string names;
    for (const int freedom : one.coordinates) {
      names += (names.empty() ? "" : ", ") + v_.mechanism.topology.freedom_name(freedom);
    }
    text += fmt::format("  state by {}; {} steps of the integration, {} evaluations\n",
                        names,
                        one.integrated,
                        one.evaluations);
    text += fmt::format("  energy balance error {} of {}\n",
                        with_unit(QuantityKind::energy, one.energy_drift),
                        with_unit(QuantityKind::energy, one.energy_scale));
    text += "  " + closure_sentence(one.closure_error) + "\n";
    return text + "\n";
  }

  // Only impacts have a speed after them.
  TextBlocks events() const {
    std::vector<TextColumn> columns = {
        {"Event", {}},
        {"of", {}},
        {fmt::format("time [{}]", units_.text(QuantityKind::time)), {}},
        {"position", {}},
        {"speed", {}},
        {"speed after", {}}};
    for (const SimulationEvent& one : v_.solution.events) {
      const auto cell = [&](QuantityKind kind, const std::optional<double>& si) {
        return si ? with_unit(kind, *si) : "-";
      };
      const QuantityKind rate = rate_kind(one.is_rotation);
      const std::array<std::string, 6> cells = {std::string(word_of(one.kind)),
                                                one.element,
                                                number(QuantityKind::time, one.time),
                                                cell(position_kind(one.is_rotation), one.position),
                                                cell(rate, one.speed),
                                                cell(rate, one.speed_after)};
      for (std::size_t i = 0; i < cells.size(); ++i) {
        columns[i].cells.push_back(cells[i]);
      }
    }
    std::erase_if(columns, [](const TextColumn& column) {
      return std::ranges::all_of(column.cells, [](const std::string& cell) { return cell == "-"; });
    });
    return TextBlocks(std::move(columns));
  }

  // But for energies, and what is always 0.
  TextBlocks extremes() const {
    const std::string at = fmt::format("at [{}]", units_.text(QuantityKind::time));
    Table table({v_.solution.looks_between_rows ? "Extremes" : "Extremes of rows and events",
                 "least",
                 at,
                 "greatest",
                 at});
    Table constants({"Does not change", "value"});
    for (const SimulationColumn& column : columns_) {
      if (!column.extremes || !column.extremes->least || column.quantity.starts_with(kEnergyWord)) {
        continue;
      }
      const SimulationExtreme& least = *column.extremes->least;
      const SimulationExtreme& greatest = *column.extremes->greatest;
      const std::string name = fmt::format("{} [{}]", column.name(), units_.text(column.kind));
      if (least.value != greatest.value) {
        table.add({name,
                   number(column.kind, least.value),
                   number(QuantityKind::time, least.time),
                   number(column.kind, greatest.value),
                   number(QuantityKind::time, greatest.time)});
      } else if (least.value != 0.0) {
        constants.add({name, number(column.kind, least.value)});
      }
    }
    TextBlocks blocks;
    for (Table* one : {&table, &constants}) {
      if (!one->is_empty()) {
        blocks += TextBlocks(std::move(*one));
      }
    }
    return blocks;
  }

  // Coordinates, energies, and what is asked for by its name.
  bool is_shown(const SimulationColumn& column) const {
    for (const std::string& name : v_.plan.report.names) {
      if (names_column(name, column.element, "", column.quantity)) {
        return true;
      }
    }
    const bool is_state = column.is_coordinate && column.quantity != "acceleration";
    return column.quantity == "time" || is_state || column.quantity.starts_with("energy/");
  }

  Table rows() const {
    std::vector<std::string> head;
    std::vector<const SimulationColumn*> shown;
    for (const SimulationColumn& column : columns_) {
      if (is_shown(column)) {
        shown.push_back(&column);
        head.push_back(fmt::format("{} [{}]", column.name(), units_.text(column.kind)));
      }
    }
    Table table(head);
    const std::size_t count = v_.solution.rows.size();
    const std::size_t stride = (count + kMostRows - 2) / (kMostRows - 1);
    for (std::size_t r = 0; r < count; ++r) {
      if (r % std::max<std::size_t>(stride, 1) != 0 && r + 1 != count) {
        continue;
      }
      std::vector<std::string> cells;
      for (const SimulationColumn* column : shown) {
        const std::optional<double>& value = column->values[r];
        cells.push_back(value ? number(column->kind, *value) : "-");
      }
      table.add(cells);
    }
    return table;
  }

  const SimulationReportView& v_;
  const FileUnits& units_;
  std::vector<SimulationColumn> columns_;
};

std::string simulation_csv(const SimulationReportView& v) {
  const FileUnits& units = v.description.units;
  const std::string name = name_in_tables(v.file, v.description);
  const std::string status(word_of(v.solution.end));
  std::string text(kSimulationCsvHeader);
  const auto line = [&](const std::string& element,
                        const std::string& quantity,
                        QuantityKind kind,
                        const std::optional<double>& value,
                        const std::string& state,
                        const std::string& step) {
    const std::string number = value ? format_exact(units.from_si(kind, *value)) : "";
    append_csv_line(
        std::array<std::string_view, 10>{
            name, "", "simulation", element, quantity, number, units.text(kind), state, step, ""},
        text);
  };
  const std::vector<SimulationColumn> columns = simulation_columns(v);
  for (std::size_t r = 0; r < v.solution.rows.size(); ++r) {
    for (const SimulationColumn& column : columns) {
      line(column.element,
           column.quantity,
           column.kind,
           column.values[r],
           status,
           std::to_string(r));
    }
  }
  for (const SimulationColumn& column : columns) {
    const auto figure = [&](const char* which, const std::optional<SimulationExtreme>& extreme) {
      if (extreme) {
        const std::string quantity = fmt::format("figure/{}/{}", column.quantity, which);
        line(column.element, quantity, column.kind, extreme->value, status, "");
        line(column.element, quantity + "_time", QuantityKind::time, extreme->time, status, "");
      }
    };
    if (column.extremes) {
      figure("least", column.extremes->least);
      figure("greatest", column.extremes->greatest);
    }
  }
  for (std::size_t e = 0; e < v.solution.events.size(); ++e) {
    const SimulationEvent& one = v.solution.events[e];
    const std::string kind(word_of(one.kind));
    const QuantityKind rate = rate_kind(one.is_rotation);
    const std::string event = fmt::format("event/{}/", e + 1);
    line(one.element, event + "time", QuantityKind::time, one.time, kind, "");
    const auto known = [&](const char* key, QuantityKind of, const std::optional<double>& value) {
      if (value) {
        line(one.element, event + key, of, value, kind, "");
      }
    };
    known("position", position_kind(one.is_rotation), one.position);
    known("speed", rate, one.speed);
    known("speed_after", rate, one.speed_after);
  }
  return text;
}

}  // namespace

SimulationBlocks simulation_blocks(const SimulationReportView& view) {
  return SimulationText(view).run();
}

FileReport make_simulation_report(const SimulationReportView& view, const ReportForms& forms) {
  FileReport report;
  add_json(simulation_report_record, view, view.description.units, forms, report);
  if (forms.csv) {
    report.csv.push_back({.pass = "simulation", .text = simulation_csv(view)});
  }
  if (forms.text) {
    report.text += title_text(view.file, view.description) + "\n";
    const SimulationBlocks blocks = simulation_blocks(view);
    report.text += blocks.end;
    report.text += blocks.extremes;
    report.text += blocks.rows;
  }
  return report;
}

}  // namespace kinestat
