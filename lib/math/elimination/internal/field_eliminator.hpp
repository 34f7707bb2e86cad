// Gaussian elimination of a sparse matrix over a field in which numbers are exact.
#pragma once

#include <algorithm>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

#include "math/elimination/internal/field_workspace.hpp"

namespace kinestat {

/// Carries the working state of one elimination; what survives is in `result`, whose rows must be
/// set, their columns ascending and no value zero.
template <class Field>
class FieldEliminator {
 public:
  FieldEliminator(FieldElimination<Field>& result, int column_count)
      : out_(result), column_count_(column_count), work_(result, column_count, Steps::kept) {}

  /// Pivots on the column with the fewest entries and there on the shortest row; on the columns of
  /// `last` after all others.
  void run(std::span<const int> last) {
    std::vector<bool> is_last(static_cast<std::size_t>(column_count_), false);
    for (const int c : last) {
      at(is_last, c) = true;
    }
    std::vector<int> first(is_last.size());
    std::iota(first.begin(), first.end(), 0);
    std::erase_if(first, [&](int c) { return at(is_last, c); });
    out_.free_columns = eliminate(first, out_.pivots);
    std::ranges::sort(out_.free_columns);
    eliminate(last, out_.last_pivots);
  }

 private:
  using Pivot = typename FieldElimination<Field>::Pivot;

  // Pivots on the candidates until none is left; gives back those that found no pivot.
  std::vector<int> eliminate(std::span<const int> candidates, std::vector<Pivot>& found) {
    for (const int column : candidates) {
      work_.columns.add(column);
    }
    std::vector<int> without;
    while (const std::optional<int> column = work_.columns.take()) {
      const std::vector<int>& holders = work_.holders(*column);
      if (holders.empty()) {
        without.push_back(*column);
        continue;
      }
      const int shortest = *std::ranges::min_element(
          holders, {}, [&](int row) { return at(out_.rows, row).size(); });
      work_.pivot_on(shortest, *column, found);
    }
    return without;
  }

  FieldElimination<Field>& out_;
  int column_count_ = 0;
  FieldWorkspace<Field> work_;
};

}  // namespace kinestat
