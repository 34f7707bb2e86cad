// A sparse matrix over a field in which numbers are exact, after Gaussian elimination.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "math/tapes/internal/at.hpp"

namespace kinestat {

/// A Field has a type Value and says of it: is_zero(a), quotient(a, b), add(a, b), which makes a +
/// b of a, and subtract_product(a, b, c), which makes a - b c of it. Zero is Value{}.
template <class Field>
struct FieldElimination {
  using Value = typename Field::Value;

  struct Cell {
    int column = 0;
    Value value{};
  };

  using Row = std::vector<Cell>;

  /// row -= multiplier · pivot row.
  struct Step {
    int row = 0;
    int pivot_row = 0;
    Value multiplier{};
  };

  struct Pivot {
    int row = 0;
    int column = 0;
    Value value{};
  };

  Field field;
  std::vector<Row> rows{};           ///< ascending columns; what is left of each, pivots included
  std::vector<Step> steps{};         ///< in the order of their application
  std::vector<Pivot> pivots{};       ///< of the columns outside `last`, in order
  std::vector<Pivot> last_pivots{};  ///< of the columns of `last`
  std::vector<int> free_columns{};   ///< outside `last` and without a pivot, ascending
  std::int64_t products = 0;         ///< how many were subtracted

  int rank() const { return static_cast<int>(pivots.size() + last_pivots.size()); }

  /// Sets the rows. Entries have a row, a column and a value, of which `image` makes one of the
  /// field; those at the same place add up.
  template <class Entry, class Image>
  void load(int row_count, const std::vector<Entry>& entries, const Image& image) {
    rows.assign(static_cast<std::size_t>(row_count), {});
    std::vector<std::size_t> counts(rows.size(), 0);
    for (const Entry& entry : entries) {
      ++at(counts, entry.row);
    }
    for (std::size_t r = 0; r < counts.size(); ++r) {
      rows[r].reserve(counts[r]);
    }
    for (const Entry& entry : entries) {
      Row& row = at(rows, entry.row);
      const auto place = std::ranges::lower_bound(row, entry.column, {}, &Cell::column);
      if (place != row.end() && place->column == entry.column) {
        field.add(place->value, image(entry.value));
      } else {
        row.insert(place, {.column = entry.column, .value = image(entry.value)});
      }
    }
    for (Row& row : rows) {
      std::erase_if(row, [this](const Cell& cell) { return field.is_zero(cell.value); });
    }
  }
};

}  // namespace kinestat
