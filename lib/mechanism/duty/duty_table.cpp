#include "mechanism/duty/duty_table.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "core/csv_reader.hpp"
#include "core/spelling.hpp"
#include "core/utf8.hpp"
#include "expression/units.hpp"
#include "mechanism/duty/internal/duty_knowns.hpp"

namespace kinestat {

namespace {

// What a column of a table holds.
struct Column {
  enum class Holds { label, duration, time, magnitude } holds = Holds::label;
  std::size_t actuator = 0;
  DutySide side = DutySide::motion;
  double factor = 1.0;  ///< SI per unit

  /// Whatever their units.
  bool holds_same(const Column& other) const {
    return holds == other.holds && actuator == other.actuator && side == other.side;
  }
};

class TableReader {
 public:
  TableReader(const MechanismDescription& description,
              const Mechanism& mechanism,
              std::string_view name,
              Diagnostics& found)
      : description_(description), mechanism_(mechanism), name_(name), found_(found) {}

  void run(std::string_view text, DutyPlan& plan) {
    CsvReader reader(text);
    const std::optional<CsvRow> head = reader.next();
    if (!head) {
      refuse(1, "E0303", "the table is empty", "its first line names the columns");
      return;
    }
    if (const std::string_view separators = other_separators(*head); !separators.empty()) {
      refuse(1,
             "E0308",
             fmt::format("{} separate the columns", separators),
             "separate them by commas, and write numbers with a decimal point");
      return;
    }
    for (const std::string& cell : head->cells) {
      columns_.push_back(column_of(cell));
    }
    check_columns(head->cells);
    std::optional<double> begin;
    while (!is_refused_) {
      const std::optional<CsvRow> row = reader.next();
      if (!row) {
        break;
      }
      add_row(*row, begin, plan);
    }
    if (reader.is_broken()) {
      refuse(reader.line(), "E0308", "a quote is not closed", "close it with \"");
    }
  }

 private:
  void refuse(int line, std::string_view code, const std::string& message, std::string hint) {
    found_.error(
        code, {}, fmt::format("{}:{}: {}", printable(name_), line, message), std::move(hint));
    is_refused_ = true;
  }

  bool has(Column::Holds what) const {
    return std::ranges::find(columns_, what, &Column::holds) != columns_.end();
  }

  void check_columns(std::span<const std::string> heads) {
    for (std::size_t i = 0; i < columns_.size() && !is_refused_; ++i) {
      const auto same = std::ranges::find_if(
          columns_, [&](const Column& one) { return one.holds_same(columns_[i]); });
      if (const auto first = static_cast<std::size_t>(same - columns_.begin()); first < i) {
        refuse(1,
               "E0307",
               fmt::format("columns '{}' and '{}' hold the same quantity",
                           printable(heads[first]),
                           printable(heads[i])),
               "keep one of them");
      }
    }
    if (is_refused_) {
      return;
    }
    const bool has_both = has(Column::Holds::duration) && has(Column::Holds::time);
    if (has_both || (!has(Column::Holds::duration) && !has(Column::Holds::time))) {
      refuse(1,
             has_both ? "E0307" : "E0303",
             has_both ? "the table has both columns 'duration' and 'time'"
                      : "the table needs one of the columns 'duration' and 'time'",
             has_both ? "keep one of them: 'time' is when each line begins"
                      : "name it with its unit: 'duration [s]', or 'time [s]' for when each line "
                        "begins");
    }
  }

  // NAME [UNIT]
  Column column_of(std::string_view head) {
    const std::size_t bracket = head.find('[');
    const bool has_unit = bracket != std::string_view::npos && head.ends_with(']');
    const std::string_view name = trimmed(has_unit ? head.substr(0, bracket) : head);
    Column column;
    if (name == "case" && !has_unit) {
      return column;
    }
    UnitExpression unit;
    if (has_unit) {
      const auto parsed = parse_unit(head.substr(bracket + 1, head.size() - bracket - 2));
      if (const auto* error = std::get_if<ExpressionError>(&parsed)) {
        refuse(1, error->code, error->message, error->hint);
        return column;
      }
      unit = std::get<UnitExpression>(parsed);
    }
    column.factor = unit.scale.factor();
    if (name == "duration" || name == "time") {
      column.holds = name == "time" ? Column::Holds::time : Column::Holds::duration;
      check_unit(head, has_unit, unit.dimension == dimension_of(QuantityKind::time), "a time");
      return column;
    }
    const std::optional<std::size_t> actuator = find_actuator(mechanism_.topology, name);
    if (!actuator) {
      refuse(1,
             "E0313",
             fmt::format("no actuator is called '{}'", printable(name)),
             "columns are 'case', 'duration [s]' or 'time [s]', and actuators with a unit: "
             "'engine [rpm]', 'engine [N*m]'");
      return column;
    }
    column.holds = Column::Holds::magnitude;
    column.actuator = *actuator;
    const QuantityKind speed = measure_of(mechanism_.topology, *actuator, DutySide::motion);
    const QuantityKind load = measure_of(mechanism_.topology, *actuator, DutySide::action);
    column.side = fits(unit.dimension, speed) ? DutySide::motion : DutySide::action;
    check_unit(head,
               has_unit,
               column.side == DutySide::motion || fits(unit.dimension, load),
               fmt::format("{} or {}", phrase_of(speed), phrase_of(load)));
    return column;
  }

  void check_unit(std::string_view head, bool has_unit, bool fits, std::string_view wanted) {
    if (!has_unit || !fits) {
      refuse(1,
             "E0309",
             fmt::format("column '{}' needs the unit of {}", printable(head), wanted),
             "write it in brackets behind the name: 'engine [rpm]'");
    }
  }

  void add_row(const CsvRow& row, std::optional<double>& begin, DutyPlan& plan) {
    if (row.cells.size() != columns_.size()) {
      refuse(
          row.line,
          "E0308",
          fmt::format("{} cells where the first line names {}", row.cells.size(), columns_.size()),
          "leave cells empty rather than out");
      return;
    }
    if (ends_only(row)) {
      const auto time = static_cast<std::size_t>(
          std::ranges::find(columns_, Column::Holds::time, &Column::holds) - columns_.begin());
      end_before(
          columns_[time].factor * number_of(row.cells[time], row.line), row.line, begin, plan);
      begin.reset();
      return;
    }
    const std::optional<std::size_t> which = case_of(row);
    if (!which) {
      return;
    }
    DutyPoint point = point_of(mechanism_, *which);
    point.line = row.line;
    for (std::size_t c = 0; c < columns_.size() && !is_refused_; ++c) {
      if (columns_[c].holds != Column::Holds::label && !trimmed(row.cells[c]).empty()) {
        take(columns_[c], number_of(row.cells[c], row.line), row.line, begin, point, plan);
      }
    }
    if (is_refused_) {
      return;
    }
    if (has(Column::Holds::duration) && !(point.duration > 0.0)) {
      refuse(row.line, "E0305", "the duration is not above zero", "give every line a duration");
      return;
    }
    plan.points.push_back(std::move(point));
  }

  // A time alone ends the line before it.
  bool ends_only(const CsvRow& row) const {
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      if ((columns_[c].holds == Column::Holds::time) == trimmed(row.cells[c]).empty()) {
        return false;
      }
    }
    return has(Column::Holds::time);
  }

  void take(const Column& column,
            double value,
            int line,
            std::optional<double>& begin,
            DutyPoint& point,
            DutyPlan& plan) {
    const double si = column.factor * value;
    switch (column.holds) {
      case Column::Holds::label:
        return;
      case Column::Holds::duration:
        point.duration = si;
        return;
      case Column::Holds::time:
        end_before(si, line, begin, plan);
        return;
      case Column::Holds::magnitude:
        break;
    }
    const std::optional<std::size_t> known =
        find_known(mechanism_, point.which, column.actuator, column.side);
    if (!known) {
      const std::string& actuator = mechanism_.topology.actuators[column.actuator].name;
      refuse(line,
             "E0313",
             fmt::format("case '{}' does not give the {} of '{}'",
                         mechanism_.cases[point.which].label,
                         word_of(column.side),
                         actuator),
             "leave the cell empty: it follows from the others there");
      return;
    }
    set_known(*known, column.side, si, point);
  }

  // The line before holds until this one begins; the last line only ends the one before it.
  void end_before(double time, int line, std::optional<double>& begin, DutyPlan& plan) {
    if (begin && !(time > *begin)) {
      refuse(line, "E0305", "time does not advance", "order the lines by time");
      return;
    }
    if (begin && !plan.points.empty()) {
      plan.points.back().duration = time - *begin;
    }
    begin = time;
  }

  std::optional<std::size_t> case_of(const CsvRow& row) {
    const auto at = std::ranges::find(columns_, Column::Holds::label, &Column::holds);
    const std::string_view cell =
        at == columns_.end() ? std::string_view()
                             : trimmed(row.cells[static_cast<std::size_t>(at - columns_.begin())]);
    const std::string label = !cell.empty()                   ? std::string(cell)
                              : description_.duty->case_label ? description_.duty->case_label->text
                                                              : std::string();
    const std::optional<std::size_t> which = label.empty() && mechanism_.cases.size() == 1
                                                 ? std::optional<std::size_t>(0)
                                                 : find_case(mechanism_, label);
    if (which) {
      if (const std::string why = why_no_point(mechanism_.cases[*which]); !why.empty()) {
        refuse(row.line, "E0303", why, std::string(kBothSidesHint));
        return std::nullopt;
      }
    } else {
      refuse(row.line,
             "E0313",
             label.empty() ? "the line names no case"
                           : fmt::format("there is no case or gear '{}'", printable(label)),
             cases_hint(mechanism_, label));
    }
    return which;
  }

  double number_of(std::string_view cell, int line) {
    const std::string_view text = trimmed(cell);
    const auto value = number_from<double>(text);
    if (!value || !std::isfinite(*value)) {
      refuse(line,
             "E0308",
             fmt::format("'{}' is not a number", printable(text.substr(0, 80))),
             "numbers have a decimal point, and their unit is in the first line");
    }
    return value.value_or(0.0);
  }

  const MechanismDescription& description_;
  const Mechanism& mechanism_;
  std::string_view name_;
  Diagnostics& found_;
  std::vector<Column> columns_;
  bool is_refused_ = false;
};

}  // namespace

void add_duty_table(const MechanismDescription& description,
                    const Mechanism& mechanism,
                    std::string_view name,
                    std::string_view text,
                    DutyPlan& plan,
                    Diagnostics& found) {
  TableReader(description, mechanism, name, found).run(text, plan);
  // The last of lines that begin at a time has no end.
  std::erase_if(plan.points, [](const DutyPoint& point) { return point.duration == 0.0; });
}

}  // namespace kinestat
