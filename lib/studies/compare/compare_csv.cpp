#include "studies/compare/compare_csv.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/utf8.hpp"
#include "report/table_archive.hpp"
#include "studies/compare/compare_place.hpp"
#include "studies/compare/csv_cell.hpp"
#include "studies/compare/ignored_keys.hpp"
#include "studies/motion/report/motion_csv.hpp"

namespace kinestat {

namespace {

// Tables of versions up to 0.2.0 have numbers for the components of vectors and screws.
std::string with_named_component(const std::string& quantity) {
  static const std::map<std::string_view, std::span<const std::string_view>> names = [] {
    static constexpr std::array<std::string_view, 3> kVector = {"x", "y", "z"};
    static constexpr std::array<std::string_view, 6> kTwist = {"wx", "wy", "wz", "vx", "vy", "vz"};
    static constexpr std::array<std::string_view, 6> kWrench = {"Tx", "Ty", "Tz", "Rx", "Ry", "Rz"};
    std::map<std::string_view, std::span<const std::string_view>> result = {{"twist", kTwist},
                                                                            {"wrench", kWrench}};
    for (const std::string_view vector :
         {"angular", "linear", "at", "force", "moment", "direction", "point", "shift"}) {
      result.emplace(vector, kVector);
    }
    return result;
  }();
  const std::size_t slash = quantity.rfind('/');
  if (slash == std::string::npos || slash + 2 != quantity.size()) {
    return quantity;
  }
  const std::string_view above = std::string_view(quantity).substr(0, slash);
  const auto of = names.find(above.substr(above.rfind('/') + 1));
  const auto index = static_cast<std::size_t>(quantity.back() - '0');
  return of == names.end() || index >= of->second.size()
             ? quantity
             : quantity.substr(0, slash + 1).append(of->second[index]);
}

// They have other names for velocities, too.
std::string named_today(const std::string& quantity) {
  const bool is_of_point = quantity.starts_with("velocity/");
  return quantity == "rate"                      ? "velocity"
         : is_of_point                           ? "linear" + quantity.substr(quantity.find('/'))
         : quantity.starts_with("acceleration/") ? "linear_" + quantity
                                                 : with_named_component(quantity);
}

// Those of a motion tell the step too, those of several files the file.
std::vector<std::string> known_columns(const CsvRow& header) {
  const auto has = [&](const char* column) {
    return std::ranges::find(header.cells, column) != header.cells.end();
  };
  std::vector<std::string> known =
      CsvReader(has("step") ? kMotionCsvHeader : kCsvHeader).next()->cells;
  if (has("file")) {
    known.insert(known.begin(), "file");
  }
  if (has("parameter")) {
    known.emplace_back("parameter");
  }
  return known;
}

// Which cell of a row is which column; empty iff an error was added.
std::optional<std::map<std::string, std::size_t>> read_header(const CsvRow& header,
                                                              Diagnostics& found) {
  const std::vector<std::string> known = known_columns(header);
  std::map<std::string, std::size_t> columns;
  for (std::size_t i = 0; i < header.cells.size(); ++i) {
    const std::string name = printable(header.cells[i].substr(0, 80));
    if (std::ranges::find(known, header.cells[i]) == known.end()) {
      refuse_line(header.line,
                  fmt::format("the table has an unknown column '{}'", name),
                  guess_before(name, known, "columns are " + plain_list(known)),
                  found);
      return {};
    }
    if (!columns.emplace(header.cells[i], i).second) {
      refuse_line(header.line, fmt::format("the table has two columns '{}'", name), "", found);
      return {};
    }
  }
  for (const std::string& name : known) {
    if (!columns.contains(name)) {
      refuse_line(header.line,
                  fmt::format("the table has no column '{}'", name),
                  fmt::format("columns are {}", plain_list(known)),
                  found);
      return {};
    }
  }
  return columns;
}

// In tables counts of mobility are the numbers that are written as whole ones.
bool is_count(std::string_view pass, std::string_view number) {
  return pass == "mobility" && number.find_first_not_of("-0123456789") == std::string_view::npos;
}

class TableReader {
 public:
  TableReader(const std::map<std::string, std::size_t>& columns, Diagnostics& found)
      : columns_(columns), found_(found) {}

  void add(const CsvRow& row) {
    if (row.cells.size() != columns_.size()) {
      refuse_line(row.line,
                  fmt::format("the row has {} cells, not {}", row.cells.size(), columns_.size()),
                  "",
                  found_);
      return;
    }
    if (!is_compared_in_tables(cell(row, "quantity"))) {
      return;
    }
    const std::string place = columns_.contains("step") ? place_in_motion(row) : place_of(row);
    if (!add_value(row, place)) {
      return;
    }
    const bool is_new =
        values_.add(place_below(place, "status"), ValueType::text, cell(row, "status"));
    if (!is_new) {
      refuse_line(row.line,
                  fmt::format("there are two rows for {}", printable(place)),
                  "compare one mechanism at a time, or give each another name",
                  found_);
    }
  }

  ReportValues take_values() { return std::move(values_); }

 private:
  const std::string& cell(const CsvRow& row, const char* column) const {
    return row.cells[columns_.at(column)];
  }

  // The element may be a path, as of "dyads/0", and the quantity is one.
  std::string place_of(const CsvRow& row) const {
    std::string place = columns_.contains("file") ? place_below("", cell(row, "file")) : "";
    place = place_below(place, compared_name(cell(row, kMechanismColumn)));
    for (const char* column : {"case", "pass"}) {
      place = place_below(place, cell(row, column));
    }
    const std::string& element = cell(row, "element");
    for (std::size_t at = 0; at <= element.size();) {
      const std::size_t end = std::min(element.find('/', at), element.size());
      place = place_below(place, element.substr(at, end - at));
      at = end + 1;
    }
    if (columns_.contains("parameter")) {
      place = place_below(place + "/by", cell(row, "parameter"));
    }
    return place + "/" + named_today(cell(row, "quantity"));
  }

  // Below that of its quantity its step; several events may lie in one, and come in their order.
  std::string place_in_motion(const CsvRow& row) {
    const std::string& step = cell(row, "step");
    const std::string place =
        step.empty() ? place_of(row) : place_below(place_of(row), "step " + step);
    if (!cell(row, "quantity").starts_with("event/")) {
      return place;
    }
    return place_below(place, std::to_string(event_counts_[place]++));
  }

  // False if an error was added. A place that is taken shows when the status is added.
  bool add_value(const CsvRow& row, const std::string& place) {
    const std::string& text = cell(row, "value");
    auto unit = read_unit(cell(row, "unit"));
    if (const auto* error = std::get_if<ExpressionError>(&unit)) {
      refuse_line(row.line, printable(error->message), error->hint, found_);
      return false;
    }
    if (text.empty()) {
      values_.add(place, ValueType::null);
      return true;
    }
    const std::optional<double> number = read_cell(text, row.line, found_);
    if (!number) {
      return false;
    }
    values_.add_number(
        place,
        *number,
        is_count(cell(row, "pass"), text) ? count_unit() : std::get<ValueUnit>(unit));
    return true;
  }

  const std::map<std::string, std::size_t>& columns_;
  Diagnostics& found_;
  std::map<std::string, int> event_counts_;
  ReportValues values_{ReportForm::csv};
};

}  // namespace

std::optional<ReportValues> read_csv_report(const SourceFile& source, Diagnostics& found) {
  CsvReader reader(source.text);
  const std::optional<CsvRow> header = reader.next();
  if (!header) {
    refuse_line(0, "the table is empty, or a quote in it is not closed", "", found);
    return {};
  }
  const auto columns = read_header(*header, found);
  if (!columns) {
    return {};
  }
  TableReader table(*columns, found);
  while (const std::optional<CsvRow> row = reader.next()) {
    const bool is_blank = row->cells.size() == 1 && row->cells.front().empty();
    if (!is_blank) {
      table.add(*row);
    }
    if (found.error_count() == kMostTableErrors) {
      return {};
    }
  }
  if (reader.is_broken()) {
    refuse_line(reader.line(), "a quote is not closed, or text follows one", "", found);
  }
  return found.has_errors() ? std::nullopt : std::optional(table.take_values());
}

}  // namespace kinestat
