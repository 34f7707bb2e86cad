#include "report/sweep_table.hpp"

#include <charconv>

namespace kinestat {

namespace {

// Takes one line of RFC 4180 from the front: cells, in quotes where they hold a comma.
std::vector<std::string> take_cells(std::string_view& csv) {
  std::vector<std::string> cells = {""};
  bool is_quoted = false;
  while (!csv.empty()) {
    const char character = csv.front();
    csv.remove_prefix(1);
    if (character == '"' && is_quoted && csv.starts_with('"')) {
      csv.remove_prefix(1);  // two within quotes are one
      cells.back() += '"';
    } else if (character == '"') {
      is_quoted = !is_quoted;
    } else if (character == ',' && !is_quoted) {
      cells.emplace_back();
    } else if (character == '\n' && !is_quoted) {
      break;
    } else {
      cells.back() += character;
    }
  }
  return cells;
}

std::optional<double> number_of(const std::string& cell) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return error == std::errc() && end == cell.data() + cell.size() ? std::optional(value)
                                                                  : std::nullopt;
}

}  // namespace

void add_sweep_rows(std::string_view csv, SweepTable& table) {
  const std::size_t varied = table.varied.size();
  while (!csv.empty()) {
    const std::vector<std::string> cells = take_cells(csv);
    if (cells.size() < varied + 1 + table.quantities.size()) {
      continue;
    }
    SweepTableRow row;
    for (std::size_t i = 0; i < varied; ++i) {
      row.places.push_back(number_of(cells[i]).value_or(0.0));
    }
    row.label = cells[varied];
    for (std::size_t i = 0; i < table.quantities.size(); ++i) {
      row.values.push_back(number_of(cells[varied + 1 + i]));
    }
    table.rows.push_back(std::move(row));
  }
}

}  // namespace kinestat
