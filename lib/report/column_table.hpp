// Tables that are put together column by column.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/types.hpp"
#include "report/table.hpp"

namespace kinestat {

/// A column of a table for people: its head and one cell a row.
struct TextColumn {
  std::string head;
  std::vector<std::string> cells;
};

/// The cell of a value that may not exist, "?" then.
std::string cell_of(const std::optional<double>& value);

/// A vector a row as columns "Fx [N]" and so on, only those that are not zero throughout. A row
/// without a value has `missing` in its cells.
struct VectorColumns {
  std::string symbol;
  std::string unit;
  std::vector<std::optional<Vec3>> rows;
  std::string missing = "?";

  void add_to(std::vector<TextColumn>& columns) const;
};

/// All columns must have the same number of cells.
Table table_of(std::vector<TextColumn> columns);

}  // namespace kinestat
