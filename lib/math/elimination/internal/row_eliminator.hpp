// Gaussian elimination over a field for the rank and null vectors alone.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "math/elimination/internal/field_workspace.hpp"

namespace kinestat {

/// For matrices that have no more columns than rows: columns without a pivot stay in the rows and
/// make them long. There it keeps rows short in chains and in grids. What survives is in `result`,
/// without the steps; its rows must be set, their columns ascending and no value zero.
template <class Field>
class RowEliminator {
 public:
  RowEliminator(FieldElimination<Field>& result, int column_count)
      : out_(result), column_count_(column_count), work_(result, column_count, Steps::forgotten) {}

  /// Pivots on the shortest row and there on the column with the fewest entries.
  void run() {
    for (int r = 0; r < static_cast<int>(out_.rows.size()); ++r) {
      work_.rows.add(r);
    }
    while (const std::optional<int> row = work_.rows.take()) {
      if (!at(out_.rows, *row).empty()) {
        const int column = rarest_column(*row);
        work_.holders(column);
        work_.pivot_on(*row, column, out_.pivots);
      }
    }
    find_free_columns();
  }

 private:
  using Elimination = FieldElimination<Field>;

  int rarest_column(int row) const {
    const auto count = [this](const typename Elimination::Cell& cell) {
      return work_.columns.count(cell.column);
    };
    return std::ranges::min_element(at(out_.rows, row), {}, count)->column;
  }

  void find_free_columns() {
    std::vector<bool> is_free(static_cast<std::size_t>(column_count_), true);
    for (const typename Elimination::Pivot& pivot : out_.pivots) {
      at(is_free, pivot.column) = false;
    }
    for (int c = 0; c < column_count_; ++c) {
      if (at(is_free, c)) {
        out_.free_columns.push_back(c);
      }
    }
  }

  Elimination& out_;
  int column_count_ = 0;
  FieldWorkspace<Field> work_;
};

}  // namespace kinestat
