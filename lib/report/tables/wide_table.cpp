#include "report/tables/wide_table.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include "core/csv_reader.hpp"
#include "report/csv.hpp"

namespace kinestat {

namespace {

constexpr std::string_view kSolved = "solved";

struct WideColumn {
  std::string pass;
  std::string element;
  std::string quantity;
  std::string parameter;  // of what changes with one; may be empty
  std::string unit;

  std::string name() const {
    return fmt::format("{}{}{}{}{}",
                       element,
                       element.empty() ? "" : "/",
                       quantity,
                       parameter.empty() ? "" : "/",
                       parameter);
  }
};

struct WideRow {
  std::vector<std::string> head;  // file, mechanism, case
  std::string step;
  std::string status;
  std::set<std::string> passes = {};          // that it has values of
  std::map<std::size_t, std::string> values;  // by the number of the column
};

class WideTable {
 public:
  explicit WideTable(std::string_view tidy) : reader_(tidy) {}

  std::string run() {
    const auto header = reader_.next();
    if (!header) {
      return {};
    }
    for (std::size_t i = 0; i < header->cells.size(); ++i) {
      places_[header->cells[i]] = i;
    }
    while (const auto row = reader_.next()) {
      add(*row);
    }
    return text();
  }

 private:
  bool has(std::string_view column) const { return places_.contains(column); }

  const std::string& cell(const CsvRow& row, std::string_view column) const {
    return row.cells[places_.find(column)->second];
  }

  void add(const CsvRow& row) {
    const bool is_of_motion = has("step");
    const std::string& quantity = cell(row, "quantity");
    const bool is_shown = is_of_motion
                              ? !cell(row, "step").empty() && !quantity.starts_with("event/")
                              : !cell(row, "case").empty();
    if (!is_shown) {
      return;
    }
    WideRow& wide = row_of(row, is_of_motion ? cell(row, "step") : "");
    const bool begins_pass = wide.passes.insert(cell(row, "pass")).second;
    if (begins_pass && (wide.status.empty() || wide.status == kSolved)) {
      wide.status = cell(row, "status");
    }
    wide.values[column_of(row)] = cell(row, "value");
  }

  WideRow& row_of(const CsvRow& row, const std::string& step) {
    std::vector<std::string> head;
    for (const std::string_view column : heads()) {
      head.push_back(cell(row, column));
    }
    const auto [at, is_new] = row_numbers_.try_emplace({head, step}, rows_.size());
    if (is_new) {
      rows_.push_back({.head = std::move(head), .step = step, .status = {}, .values = {}});
    }
    return rows_[at->second];
  }

  std::size_t column_of(const CsvRow& row) {
    const WideColumn column = {.pass = cell(row, "pass"),
                               .element = cell(row, "element"),
                               .quantity = cell(row, "quantity"),
                               .parameter = has("parameter") ? cell(row, "parameter") : "",
                               .unit = cell(row, "unit")};
    const auto [at, is_new] = column_numbers_.try_emplace(
        {column.pass, column.element, column.quantity, column.parameter, column.unit},
        columns_.size());
    if (is_new) {
      columns_.push_back(column);
    }
    return at->second;
  }

  std::vector<std::string_view> heads() const {
    std::vector<std::string_view> names = {"mechanism", "case"};
    if (has("file")) {
      names.insert(names.begin(), "file");
    }
    return names;
  }

  std::vector<std::string> titles() const {
    std::map<std::string, std::set<std::string>> passes;  // by the name of the column
    for (const WideColumn& one : columns_) {
      passes[one.name()].insert(one.pass);
    }
    std::vector<std::string> result;
    for (const WideColumn& one : columns_) {
      const std::string name = one.name();
      result.push_back(fmt::format("{}{}{}",
                                   passes[name].size() > 1 ? one.pass + "/" : "",
                                   name,
                                   one.unit.empty() ? "" : fmt::format(" [{}]", one.unit)));
    }
    return result;
  }

  std::string text() const {
    std::vector<std::string> cells;
    for (const std::string_view head : heads()) {
      cells.emplace_back(head);
    }
    cells.emplace_back("status");
    if (has("step")) {
      cells.emplace_back("step");
    }
    for (std::string& title : titles()) {
      cells.push_back(std::move(title));
    }
    std::string result = csv_line(cells);
    for (const WideRow& row : rows_) {
      cells = row.head;
      cells.push_back(row.status);
      if (has("step")) {
        cells.push_back(row.step);
      }
      for (std::size_t i = 0; i < columns_.size(); ++i) {
        const auto value = row.values.find(i);
        cells.push_back(value == row.values.end() ? std::string() : value->second);
      }
      result += csv_line(cells);
    }
    return result;
  }

  CsvReader reader_;
  std::map<std::string, std::size_t, std::less<>> places_;  // of the columns of the tidy table
  std::vector<WideColumn> columns_;
  std::map<std::tuple<std::string, std::string, std::string, std::string, std::string>, std::size_t>
      column_numbers_;
  std::vector<WideRow> rows_;
  std::map<std::pair<std::vector<std::string>, std::string>, std::size_t> row_numbers_;
};

}  // namespace

std::string wide_table(std::string_view tidy) {
  return WideTable(tidy).run();
}

}  // namespace kinestat
