// Gaussian elimination of a sparse matrix over a field in which numbers are exact.
#pragma once

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "math/internal/at.hpp"
#include "math/internal/count_queue.hpp"
#include "math/internal/field_elimination.hpp"

namespace kinestat {

/// Carries the working state of one elimination; what survives is in `result`, whose rows must be
/// set, their columns ascending and no value zero.
template <class Field>
class FieldEliminator {
 public:
  FieldEliminator(FieldElimination<Field>& result, int column_count)
      : out_(result),
        rows_of_(static_cast<std::size_t>(column_count)),
        queue_(column_count),
        active_(result.rows.size(), true) {}

  /// Pivots on the column with the fewest entries and there on the shortest row; on the columns of
  /// `last` after all others.
  void run(std::span<const int> last) {
    for (std::size_t r = 0; r < out_.rows.size(); ++r) {
      for (const Cell& cell : out_.rows[r]) {
        enter(static_cast<int>(r), cell.column);
      }
    }
    std::vector<bool> is_last(rows_of_.size(), false);
    for (const int c : last) {
      at(is_last, c) = true;
    }
    std::vector<int> first(rows_of_.size());
    std::iota(first.begin(), first.end(), 0);
    std::erase_if(first, [&](int c) { return at(is_last, c); });
    out_.free_columns = eliminate(first, out_.pivots);
    std::ranges::sort(out_.free_columns);
    eliminate(last, out_.last_pivots);
  }

 private:
  using Result = FieldElimination<Field>;
  using Cell = typename Result::Cell;
  using Row = typename Result::Row;
  using Pivot = typename Result::Pivot;
  using Value = typename Field::Value;

  void enter(int row, int column) {
    at(rows_of_, column).push_back(row);
    queue_.change(column, 1);
  }

  const Cell* find(int row, int column) const {
    const auto found = std::ranges::lower_bound(at(out_.rows, row), column, {}, &Cell::column);
    return found != at(out_.rows, row).end() && found->column == column ? &*found : nullptr;
  }

  // Pivots on the candidates until none is left; gives back those that found no pivot.
  std::vector<int> eliminate(std::span<const int> candidates, std::vector<Pivot>& found) {
    for (const int column : candidates) {
      queue_.add(column);
    }
    std::vector<int> without;
    while (const std::optional<int> column = queue_.take()) {
      const int row = shortest_row(*column);
      if (row < 0) {
        without.push_back(*column);
      } else {
        pivot_on(row, *column, found);
      }
    }
    return without;
  }

  // Also forgets the rows that no longer hold the column, and those that are listed twice because
  // an entry was lost and filled in again.
  int shortest_row(int column) {
    std::vector<int>& holders = at(rows_of_, column);
    std::ranges::sort(holders);
    holders.erase(std::unique(holders.begin(), holders.end()), holders.end());
    std::erase_if(holders, [&](int r) { return !at(active_, r) || find(r, column) == nullptr; });
    const auto best =
        std::ranges::min_element(holders, {}, [&](int r) { return at(out_.rows, r).size(); });
    return best == holders.end() ? -1 : *best;
  }

  void pivot_on(int row, int column, std::vector<Pivot>& found) {
    at(active_, row) = false;
    for (const Cell& cell : at(out_.rows, row)) {
      queue_.change(cell.column, -1);
    }
    found.push_back({.row = row, .column = column, .value = find(row, column)->value});
    for (const int r : at(rows_of_, column)) {
      if (r != row) {
        subtract(r, row, column, out_.field.quotient(find(r, column)->value, found.back().value));
      }
    }
  }

  // row -= multiplier · pivot row.
  void subtract(int row, int pivot_row, int column, Value multiplier) {
    Row& a = at(out_.rows, row);
    out_.products += static_cast<std::int64_t>(at(out_.rows, pivot_row).size()) - 1;
    merged_.clear();
    std::size_t i = 0;
    for (const Cell& cell : at(out_.rows, pivot_row)) {
      while (i < a.size() && a[i].column < cell.column) {
        merged_.push_back(std::move(a[i++]));
      }
      Cell sum{.column = cell.column, .value = {}};
      const bool was_there = i < a.size() && a[i].column == cell.column;
      if (was_there) {
        sum.value = std::move(a[i++].value);
      }
      if (cell.column != column) {
        out_.field.subtract_product(sum.value, multiplier, cell.value);
      }
      if (!was_there) {
        enter(row, cell.column);
      } else if (cell.column == column || out_.field.is_zero(sum.value)) {
        queue_.change(cell.column, -1);
        continue;
      }
      merged_.push_back(std::move(sum));
    }
    std::move(a.begin() + static_cast<std::ptrdiff_t>(i), a.end(), std::back_inserter(merged_));
    a.swap(merged_);
    out_.steps.push_back({.row = row, .pivot_row = pivot_row, .multiplier = std::move(multiplier)});
  }

  Result& out_;
  std::vector<std::vector<int>> rows_of_;  ///< of a column; may name rows that lost it
  CountQueue queue_;                       ///< columns by their entries in active rows
  std::vector<bool> active_;
  Row merged_;  ///< of subtract
};

}  // namespace kinestat
