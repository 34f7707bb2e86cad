#include "report/column_table.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/axis_name.hpp"
#include "core/contract.hpp"
#include "report/number_format.hpp"

namespace kinestat {

std::string cell_of(const std::optional<double>& value) {
  return value ? format_short(*value) : "?";
}

void VectorColumns::add_to(std::vector<TextColumn>& columns) const {
  for (std::size_t i = 0; i < kAxisNames.size(); ++i) {
    const auto part = static_cast<Eigen::Index>(i);
    const bool is_used = std::ranges::any_of(
        rows, [&](const std::optional<Vec3>& row) { return row && (*row)[part] != 0.0; });
    if (!is_used) {
      continue;
    }
    TextColumn column{.head = fmt::format("{}{} [{}]", symbol, kAxisNames[i], unit), .cells = {}};
    for (const std::optional<Vec3>& row : rows) {
      column.cells.push_back(row ? format_short((*row)[part]) : missing);
    }
    columns.push_back(std::move(column));
  }
}

Table table_of(std::vector<TextColumn> columns) {
  std::vector<std::string> head;
  for (TextColumn& column : columns) {
    KINESTAT_EXPECTS(column.cells.size() == columns.front().cells.size());
    head.push_back(std::move(column.head));
  }
  Table table(std::move(head));
  for (std::size_t r = 0; r < columns.front().cells.size(); ++r) {
    std::vector<std::string> row;
    for (TextColumn& column : columns) {
      row.push_back(std::move(column.cells[r]));
    }
    table.add(std::move(row));
  }
  return table;
}

}  // namespace kinestat
