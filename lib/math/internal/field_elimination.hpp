// A sparse matrix over a field in which numbers are exact, after Gaussian elimination.
#pragma once

#include <vector>

namespace kinestat {

/// A Field has a type Value and says of it: is_zero(a), quotient(a, b), and subtract_product(a, b,
/// c), which makes a - b c of a. Zero is Value{}.
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
  std::vector<Row> rows;           ///< ascending columns; what is left of each, pivots included
  std::vector<Step> steps;         ///< in the order of their application
  std::vector<Pivot> pivots;       ///< of the columns outside `last`, in order
  std::vector<Pivot> last_pivots;  ///< of the columns of `last`
  std::vector<int> free_columns;   ///< outside `last` and without a pivot, ascending

  int rank() const { return static_cast<int>(pivots.size() + last_pivots.size()); }
};

}  // namespace kinestat
