// Finds the steps of an elimination tape: pivots by the rules of Elimination.
#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "math/elimination_tape.hpp"

namespace kinestat {

/// Works on cells, of which a row is a map by column.
class TapeRecorder {
 public:
  TapeRecorder(const SparseMatrix& matrix,
               const std::vector<bool>& varies,
               std::span<const int> last);

  /// False if there is no tape.
  bool run(std::span<const int> wanted);

  EliminationTape take() { return std::move(tape_); }

 private:
  using Row = std::map<int, int>;  // cell by column

  struct Pivot {
    int row = 0;
    int column = 0;
    int cell = 0;
  };

  double size_of(int cell) const;
  bool choose(int column, Pivot& pivot) const;
  bool pivot_once();
  void eliminate(const Pivot& pivot);
  void subtract(int row, const Pivot& pivot);
  int fill_in(Row& row, int column);
  bool step(EliminationTape::Step step, double factor, bool varies, bool is_fill);
  bool surplus_has_vanished();
  void record_substitutions(std::span<const int> wanted);

  EliminationTape tape_;        // its cells are left as they are before the first step that varies
  std::vector<double> values_;  ///< of each cell, for the matrix that is recorded
  std::vector<Row> rows_;
  std::vector<std::set<int>> columns_;  ///< active rows that hold the column
  std::vector<bool> active_;
  std::vector<bool> varies_;  ///< of each cell
  std::vector<int> open_;     ///< columns that have no pivot yet
  std::vector<Pivot> pivots_;
};

}  // namespace kinestat
