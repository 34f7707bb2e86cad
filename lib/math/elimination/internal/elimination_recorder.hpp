// Records the steps of an elimination: pivots by the rules of Elimination.
#pragma once

#include <map>
#include <set>
#include <span>
#include <vector>

#include "math/elimination/elimination_tape.hpp"
#include "math/elimination/equilibrate.hpp"

namespace kinestat {

/// Works on rows, of which each is a map by column of what is not zero in all lanes.
class EliminationRecorder {
 public:
  EliminationRecorder(const TapedMatrix& matrix,
                      std::span<const TapedUnknown> known,
                      LaneRecorder& recorder);

  /// Eliminates; false if there is no tape.
  bool run();

  /// After run: the unknowns of these columns.
  std::vector<TapeNumber> substitute(std::span<const int> wanted);

 private:
  using Row = std::map<int, TapeNumber>;  // by column

  struct Pivot {
    int row = 0;
    int column = 0;
  };

  double size_of(int row, int column) const;
  bool choose(int column, Pivot& pivot) const;
  bool pivot_once();
  void eliminate(const Pivot& pivot);
  void subtract(int row, const Pivot& pivot);
  void set(int row, int column, TapeNumber value);
  bool demand_surplus();

  LaneRecorder& recorder_;
  Scaling scaling_;
  std::vector<Row> rows_;
  std::vector<std::set<int>> columns_;  ///< active rows that hold the column
  std::vector<bool> active_;
  std::vector<int> open_;  ///< columns that have no pivot yet
  std::vector<Pivot> pivots_;
  std::map<int, TapeNumber> unknowns_;  ///< by column, in the units of the scaling
};

}  // namespace kinestat
