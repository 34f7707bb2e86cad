#include "studies/compare/compare_csv.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/utf8.hpp"
#include "report/table_archive.hpp"
#include "studies/compare/compare_place.hpp"
#include "studies/motion/report/motion_csv.hpp"

namespace kinestat {

namespace {

// A file that is no table at all would have an error in every line.
constexpr int kMostErrors = 20;

struct CsvRow {
  int line = 0;  ///< where it begins
  std::vector<std::string> cells;
};

// Reads row by row, by RFC 4180.
class CsvReader {
 public:
  explicit CsvReader(std::string_view text) : rest_(text) {
    if (rest_.starts_with(kByteOrderMark)) {
      rest_.remove_prefix(kByteOrderMark.size());
    }
  }

  // The next row; empty at the end, or when a quote is not closed.
  std::optional<CsvRow> next() {
    if (rest_.empty()) {
      return {};
    }
    CsvRow row{.line = line_, .cells = {}};
    do {
      row.cells.push_back(cell());
    } while (!is_broken_ && take(','));
    is_broken_ = is_broken_ || !ends_line();
    ++line_;
    return is_broken_ ? std::nullopt : std::optional(std::move(row));
  }

  bool is_broken() const { return is_broken_; }

  int line() const { return line_; }

 private:
  bool take(char c) {
    const bool is_next = rest_.starts_with(c);
    rest_.remove_prefix(is_next ? 1 : 0);
    return is_next;
  }

  bool ends_line() {
    take('\r');
    return rest_.empty() || take('\n');
  }

  std::string cell() {
    if (take('"')) {
      return quoted();
    }
    const std::size_t end = std::min(rest_.find_first_of(",\r\n"), rest_.size());
    std::string text(rest_.substr(0, end));
    rest_.remove_prefix(end);
    return text;
  }

  std::string quoted() {
    std::string text;
    while (true) {
      const std::size_t end = rest_.find('"');
      if (end == std::string_view::npos) {
        is_broken_ = true;
        return text;
      }
      text += rest_.substr(0, end);
      line_ += static_cast<int>(std::ranges::count(rest_.substr(0, end), '\n'));
      rest_.remove_prefix(end + 1);
      if (!take('"')) {
        return text;
      }
      text += '"';
    }
  }

  std::string_view rest_;
  int line_ = 1;
  bool is_broken_ = false;
};

void refuse(int line, std::string message, std::string hint, Diagnostics& found) {
  found.error("E0903",
              line == 0 ? SourceRange{} : SourceRange{.line = line, .column = 1, .length = 1},
              std::move(message),
              std::move(hint));
}

// Those of a motion tell the step too.
std::vector<std::string> known_columns(const CsvRow& header) {
  const bool is_motion = std::ranges::find(header.cells, "step") != header.cells.end();
  return CsvReader(is_motion ? kMotionCsvHeader : kCsvHeader).next()->cells;
}

// Which cell of a row is which column; empty iff an error was added.
std::optional<std::map<std::string, std::size_t>> read_header(const CsvRow& header,
                                                              Diagnostics& found) {
  const std::vector<std::string> known = known_columns(header);
  std::map<std::string, std::size_t> columns;
  for (std::size_t i = 0; i < header.cells.size(); ++i) {
    const std::string name = printable(header.cells[i].substr(0, 80));
    if (std::ranges::find(known, header.cells[i]) == known.end()) {
      const std::string guess = did_you_mean(name, known);
      refuse(header.line,
             fmt::format("the table has an unknown column '{}'", name),
             fmt::format("{}{}columns are {}", guess, guess.empty() ? "" : " ", plain_list(known)),
             found);
      return {};
    }
    if (!columns.emplace(header.cells[i], i).second) {
      refuse(header.line, fmt::format("the table has two columns '{}'", name), "", found);
      return {};
    }
  }
  for (const std::string& name : known) {
    if (!columns.contains(name)) {
      refuse(header.line,
             fmt::format("the table has no column '{}'", name),
             fmt::format("columns are {}", plain_list(known)),
             found);
      return {};
    }
  }
  return columns;
}

// A finite number and nothing else, in any locale.
std::optional<double> number_of(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_number =
      error == std::errc() && end == text.data() + text.size() && std::isfinite(value);
  return is_number ? std::optional(value) : std::nullopt;
}

class TableReader {
 public:
  TableReader(const std::map<std::string, std::size_t>& columns, Diagnostics& found)
      : columns_(columns), found_(found) {}

  void add(const CsvRow& row) {
    if (row.cells.size() != columns_.size()) {
      refuse(row.line,
             fmt::format("the row has {} cells, not {}", row.cells.size(), columns_.size()),
             "",
             found_);
      return;
    }
    const std::string place = columns_.contains("step") ? place_in_motion(row) : place_of(row);
    if (!add_value(row, place)) {
      return;
    }
    const bool is_new = values_.add({.place = place_below(place, "status"),
                                     .type = ValueType::text,
                                     .text = cell(row, "status")});
    if (!is_new) {
      refuse(row.line,
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

  // The quantity is a path already.
  std::string place_of(const CsvRow& row) const {
    std::string place;
    for (const char* column : {"mechanism", "case", "pass", "element"}) {
      place = place_below(place, cell(row, column));
    }
    return place + "/" + cell(row, "quantity");
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
      refuse(row.line, printable(error->message), error->hint, found_);
      return false;
    }
    if (text.empty()) {
      values_.add({.place = place, .type = ValueType::null, .text = {}});
      return true;
    }
    const std::optional<double> number = number_of(text);
    if (!number) {
      refuse(row.line,
             fmt::format("'{}' is no number", printable(text.substr(0, 80))),
             "numbers have a decimal point, and the cell is empty where there is no value",
             found_);
      return false;
    }
    const bool is_count = cell(row, "pass") == "mobility";
    values_.add_number(place, *number, is_count ? count_unit() : std::get<ValueUnit>(unit));
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
    refuse(0, "the table is empty, or a quote in it is not closed", "", found);
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
    if (found.error_count() == kMostErrors) {
      return {};
    }
  }
  if (reader.is_broken()) {
    refuse(reader.line(), "a quote is not closed, or text stands behind one", "", found);
  }
  return found.has_errors() ? std::nullopt : std::optional(table.take_values());
}

}  // namespace kinestat
