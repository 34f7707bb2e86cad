// Rows on which an elimination over a field works.
#pragma once

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "math/elimination/internal/count_queue.hpp"
#include "math/elimination/internal/field_elimination.hpp"
#include "math/tapes/internal/at.hpp"

namespace kinestat {

/// Whether an elimination keeps its steps, which right-hand sides need and ranks do not.
enum class Steps { kept, forgotten };

/// Knows which active rows hold a column, and counts both ways. The rows of `result` must be set,
/// their columns ascending and no value zero.
template <class Field>
class FieldWorkspace {
 public:
  using Result = FieldElimination<Field>;
  using Cell = typename Result::Cell;
  using Row = typename Result::Row;
  using Pivot = typename Result::Pivot;
  using Value = typename Field::Value;

  FieldWorkspace(Result& result, int column_count, Steps steps)
      : columns(column_count),
        rows(static_cast<int>(result.rows.size())),
        out_(result),
        rows_of_(static_cast<std::size_t>(column_count)),
        active_(result.rows.size(), true),
        keeps_steps_(steps == Steps::kept) {
    reserve();
    for (int r = 0; r < static_cast<int>(out_.rows.size()); ++r) {
      rows.change(r, static_cast<int>(at(out_.rows, r).size()));
      for (const Cell& cell : at(out_.rows, r)) {
        enter(r, cell.column);
      }
    }
  }

  CountQueue columns;  ///< by their entries in active rows
  CountQueue rows;     ///< by their length

  /// The active rows that hold the column, ascending. Also forgets those that lost it, and those
  /// listed twice because an entry was lost and filled in again.
  const std::vector<int>& holders(int column) {
    std::vector<int>& list = at(rows_of_, column);
    std::ranges::sort(list);
    list.erase(std::unique(list.begin(), list.end()), list.end());
    std::erase_if(list, [&](int r) { return !at(active_, r) || find(r, column) == nullptr; });
    return list;
  }

  /// Takes the column out of all active rows but this one, which becomes inactive. `holders` of the
  /// column must have been asked for since the last pivot.
  void pivot_on(int row, int column, std::vector<Pivot>& found) {
    at(active_, row) = false;
    for (const Cell& cell : at(out_.rows, row)) {
      columns.change(cell.column, -1);
    }
    found.push_back({.row = row, .column = column, .value = find(row, column)->value});
    for (const int r : at(rows_of_, column)) {
      if (r != row) {
        subtract(r, row, column, out_.field.quotient(find(r, column)->value, found.back().value));
      }
    }
  }

 private:
  void reserve() {
    std::vector<std::size_t> counts(rows_of_.size(), 0);
    for (const Row& row : out_.rows) {
      for (const Cell& cell : row) {
        ++at(counts, cell.column);
      }
    }
    for (std::size_t c = 0; c < counts.size(); ++c) {
      rows_of_[c].reserve(counts[c]);
    }
  }

  void enter(int row, int column) {
    at(rows_of_, column).push_back(row);
    columns.change(column, 1);
  }

  const Cell* find(int row, int column) const {
    const auto found = std::ranges::lower_bound(at(out_.rows, row), column, {}, &Cell::column);
    return found != at(out_.rows, row).end() && found->column == column ? &*found : nullptr;
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
        columns.change(cell.column, -1);
        continue;
      }
      merged_.push_back(std::move(sum));
    }
    std::move(a.begin() + static_cast<std::ptrdiff_t>(i), a.end(), std::back_inserter(merged_));
    rows.change(row, static_cast<int>(merged_.size()) - static_cast<int>(a.size()));
    a.swap(merged_);
    if (keeps_steps_) {
      out_.steps.push_back(
          {.row = row, .pivot_row = pivot_row, .multiplier = std::move(multiplier)});
    }
  }

  Result& out_;
  std::vector<std::vector<int>> rows_of_;  ///< of a column; may name rows that lost it
  std::vector<bool> active_;
  bool keeps_steps_ = true;
  Row merged_;  ///< of subtract
};

}  // namespace kinestat
