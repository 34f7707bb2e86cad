// The elimination itself: pivots chosen on the way, rows updated in place.
#pragma once

#include <vector>

#include "math/elimination/elimination.hpp"
#include "math/elimination/internal/column_queue.hpp"

namespace kinestat {

/// Carries the working state of one elimination; what survives goes into its Elimination.
class Eliminator {
 public:
  explicit Eliminator(Elimination& result);

  void run();

 private:
  using Cell = Elimination::Cell;
  using Row = std::vector<Cell>;

  struct Choice {
    int row = -1;
    double value = 0.0;    ///< of the pivot
    double largest = 0.0;  ///< magnitude in the column
  };

  void load();
  void reserve(const SparseMatrix& matrix);
  static void sort_and_add(Row& row);
  void enter(int row, int column);
  void count(int column, int change);
  double value_at(int row, int column) const;
  Choice choose_row(int column);
  void eliminate(std::vector<int>& candidates, std::vector<Elimination::Pivot>& pivots);
  void settle(std::vector<int>& waiting,
              std::vector<int>& without,
              std::vector<Elimination::Pivot>& pivots);
  void pivot_on(int column, const Choice& choice, std::vector<Elimination::Pivot>& pivots);
  void subtract(int row, int pivot_row, int column, double multiplier);

  Elimination& out_;
  std::vector<Row>& rows_;
  std::vector<std::vector<int>> columns_;  ///< rows of each; some are done, or have lost the entry
  std::vector<int> counts_;                ///< of each column: entries in active rows
  std::vector<bool> active_;
  std::vector<double> values_;    ///< of choose_row
  Row merged_;                    ///< of subtract
  ColumnQueue* queue_ = nullptr;  ///< while columns are chosen by their counts, if it must be told
};

}  // namespace kinestat
