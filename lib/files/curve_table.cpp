#include "files/curve_table.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "core/csv_reader.hpp"
#include "core/sha256.hpp"
#include "core/text.hpp"
#include "core/utf8.hpp"
#include "expression/units.hpp"

namespace kinestat {

namespace {

bool is_finite_number(std::string_view text) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && rest == end && std::isfinite(number);
}

std::string hex(std::span<const std::uint8_t> bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes) {
    text += fmt::format("{:02x}", byte);
  }
  return text;
}

class CurveTableReader {
 public:
  CurveTableReader(std::string name, SourceRange where, Diagnostics& found)
      : name_(std::move(name)), where_(where), found_(found) {}

  // Empty iff an error was added.
  std::optional<std::vector<CurvePointDescription>> read(std::string_view text) {
    CsvReader reader(text);
    const std::optional<CsvRow> head = reader.next();
    const std::string_view separators = head ? other_separators(*head) : std::string_view();
    if (!separators.empty()) {
      refuse(1,
             fmt::format("{} separate the columns", separators),
             "separate them by a comma, and write numbers with a decimal point");
      return std::nullopt;
    }
    if (!head || head->cells.size() != units_.size()) {
      refuse(1,
             "a table of a curve has two columns, arguments and values",
             "its first line names them with their units: turn [deg],force [N]");
      return std::nullopt;
    }
    for (std::size_t i = 0; i < units_.size() && !is_refused_; ++i) {
      read_unit(head->cells[i], units_[i]);
    }
    std::vector<CurvePointDescription> points;
    while (!is_refused_) {
      const std::optional<CsvRow> row = reader.next();
      if (!row) {
        break;
      }
      add_row(*row, points);
    }
    if (reader.is_broken()) {
      refuse(reader.line(), "a quote is not closed", "close it with \"");
    }
    return is_refused_ ? std::nullopt : std::optional(std::move(points));
  }

 private:
  void refuse(int line, const std::string& message, std::string hint) {
    found_.error(
        "E0308", {}, fmt::format("{}:{}: {}", printable(name_), line, message), std::move(hint));
    is_refused_ = true;
  }

  // NAME [UNIT], or a name alone.
  void read_unit(std::string_view cell, std::string& unit) {
    if (is_finite_number(trimmed(cell))) {
      refuse(1,
             "the first line of a table of a curve names its columns",
             "write them above the numbers, with their units: turn [deg],force [N]");
      return;
    }
    const std::size_t bracket = cell.find('[');
    if (bracket == std::string_view::npos || !cell.ends_with(']')) {
      return;
    }
    unit = cell.substr(bracket + 1, cell.size() - bracket - 2);
    const auto parsed = parse_unit(unit);
    if (const auto* error = std::get_if<ExpressionError>(&parsed)) {
      refuse(1, error->message, error->hint);
    }
  }

  void add_row(const CsvRow& row, std::vector<CurvePointDescription>& points) {
    if (row.cells.size() == 1 && trimmed(row.cells.front()).empty()) {
      return;
    }
    if (row.cells.size() != units_.size()) {
      refuse(row.line,
             fmt::format("{} cells where a point has two", row.cells.size()),
             "write place and value, with a comma between them");
      return;
    }
    std::optional<Value> at = value_of(row, 0);
    std::optional<Value> value = at ? value_of(row, 1) : std::nullopt;
    if (value) {
      points.push_back({.at = *std::move(at), .value = *std::move(value)});
    }
  }

  std::optional<Value> value_of(const CsvRow& row, std::size_t column) {
    const std::string number(trimmed(row.cells[column]));
    auto parsed =
        is_finite_number(number)
            ? parse_expression(units_[column].empty() ? number : number + " " + units_[column])
            : std::variant<Expression, ExpressionError>(ExpressionError{});
    if (auto* const expression = std::get_if<Expression>(&parsed)) {
      return Value{.expression = std::move(*expression), .where = where_};
    }
    refuse(row.line,
           fmt::format("'{}' is not a number", printable(number)),
           "write plain numbers with a decimal point; their unit is in the first line");
    return std::nullopt;
  }

  std::string name_;
  SourceRange where_;
  Diagnostics& found_;
  std::array<std::string, 2> units_;
  bool is_refused_ = false;
};

}  // namespace

void apply_curve_table(const std::string& text,
                       const ReadLimits& limits,
                       MechanismDescription& description,
                       Diagnostics& found) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
    found.error("E0101",
                {},
                fmt::format("--curve '{}': this is not NAME=FILE", printable(text)),
                "write for example --curve gas=indicator.csv");
    return;
  }
  const std::string name = text.substr(0, equals);
  const std::string path = text.substr(equals + 1);
  const auto curve = std::ranges::find(
      description.curves, name, [](const CurveDescription& one) { return one.name.text; });
  if (curve == description.curves.end()) {
    std::vector<std::string> names;
    for (const CurveDescription& one : description.curves) {
      names.push_back(one.name.text);
    }
    found.error("E0101",
                {},
                fmt::format("--curve: the file has no curve '{}'", printable(name)),
                names.empty() ? "add it to a section 'curves:', with what it is over"
                              : guess_before(name, names, "its curves are " + plain_list(names)));
    return;
  }
  const std::optional<SourceFile> table = read_file(path, limits, found);
  if (!table) {
    return;
  }
  auto points = CurveTableReader(path, curve->name.where, found).read(table->text);
  if (points) {
    curve->points = *std::move(points);
    curve->table = path;
    curve->table_hash = hex(sha256(table->text));
  }
}

}  // namespace kinestat
