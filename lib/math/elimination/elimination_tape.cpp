#include "math/elimination/elimination_tape.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "math/elimination/equilibrate.hpp"
#include "math/tapes/internal/at.hpp"

namespace kinestat {

namespace {

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

// A factor beyond this means that the pivot was chosen for another matrix.
constexpr double kLargestFactor = 100.0;

// What is zero here alone says nothing about the size of its row.
SparseMatrix values_of(const TapedMatrix& matrix, const LaneRecorder& recorder) {
  SparseMatrix values{.rows = matrix.rows, .columns = matrix.columns, .entries = {}};
  for (const TapedEntry& entry : matrix.entries) {
    values.add(entry.row, entry.column, recorder.value(entry.value));
  }
  return values;
}

EliminationRecorder::EliminationRecorder(const TapedMatrix& matrix,
                                         std::span<const TapedUnknown> known,
                                         LaneRecorder& recorder)
    : recorder_(recorder),
      scaling_(find_scaling(values_of(matrix, recorder))),
      rows_(static_cast<std::size_t>(matrix.rows)),
      columns_(static_cast<std::size_t>(matrix.columns)),
      active_(rows_.size(), true) {
  for (const TapedEntry& entry : matrix.entries) {
    KINESTAT_EXPECTS(!at(rows_, entry.row).contains(entry.column));
    const double scale = at(scaling_.rows, entry.row) * at(scaling_.columns, entry.column);
    set(entry.row, entry.column, recorder_.multiply(entry.value, recorder_.constant(scale)));
  }
  for (const TapedUnknown& one : known) {
    const double unit = at(scaling_.columns, one.column);
    unknowns_[one.column] = recorder_.divide(one.value, recorder_.constant(unit));
  }
  for (int c = 0; c < matrix.columns; ++c) {
    if (!unknowns_.contains(c)) {
      open_.push_back(c);
    }
  }
}

void EliminationRecorder::set(int row, int column, TapeNumber value) {
  if (recorder_.is_zero(value)) {
    at(rows_, row).erase(column);
    at(columns_, column).erase(row);
  } else {
    at(rows_, row)[column] = value;
    at(columns_, column).insert(row);
  }
}

double EliminationRecorder::size_of(int row, int column) const {
  return std::abs(recorder_.value(at(rows_, row).at(column)));
}

// The sparsest row with a sufficient entry; false where all are small.
bool EliminationRecorder::choose(int column, Pivot& pivot) const {
  double largest = 0.0;
  for (const int r : at(columns_, column)) {
    largest = std::max(largest, size_of(r, column));
  }
  if (largest < kSafePivot) {
    return false;
  }
  std::size_t shortest = 0;
  bool is_found = false;
  for (const int r : at(columns_, column)) {
    const Row& row = at(rows_, r);
    if (size_of(r, column) >= kPivotShare * largest && (!is_found || row.size() < shortest)) {
      pivot = {.row = r, .column = column};
      shortest = row.size();
      is_found = true;
    }
  }
  return is_found;
}

// On the column with the fewest entries of those that have a good one.
bool EliminationRecorder::pivot_once() {
  std::vector<std::pair<int, int>> by_count;
  for (const int column : open_) {
    by_count.emplace_back(static_cast<int>(at(columns_, column).size()), column);
  }
  std::ranges::sort(by_count);
  for (const auto& [count, column] : by_count) {
    Pivot pivot;
    if (choose(column, pivot)) {
      std::erase(open_, column);
      eliminate(pivot);
      return true;
    }
  }
  return false;
}

void EliminationRecorder::eliminate(const Pivot& pivot) {
  at(active_, pivot.row) = false;
  recorder_.demand_at_least(at(rows_, pivot.row).at(pivot.column), recorder_.constant(kSafePivot));
  for (const auto& [column, value] : at(rows_, pivot.row)) {
    at(columns_, column).erase(pivot.row);
  }
  const std::set<int> others = at(columns_, pivot.column);
  for (const int r : others) {
    subtract(r, pivot);
  }
  pivots_.push_back(pivot);
}

void EliminationRecorder::subtract(int row, const Pivot& pivot) {
  const Row& source = at(rows_, pivot.row);
  Row& target = at(rows_, row);
  const TapeNumber factor = recorder_.divide(target.at(pivot.column), source.at(pivot.column));
  recorder_.demand_at_most(factor, recorder_.constant(kLargestFactor));
  set(row, pivot.column, recorder_.constant(0.0));
  for (const auto& [column, value] : source) {
    if (column != pivot.column) {
      const auto present = target.find(column);
      set(row,
          column,
          present == target.end() ? recorder_.negate_product(factor, value)
                                  : recorder_.subtract_product(present->second, factor, value));
    }
  }
}

// Rows that have no pivot follow from the others, up to rounding.
bool EliminationRecorder::demand_surplus() {
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    for (const auto& [column, value] : rows_[r]) {
      if (!active_[r]) {
        continue;
      }
      if (std::abs(recorder_.value(value)) > kRankZero) {
        return false;
      }
      recorder_.demand_at_most(value, recorder_.constant(kRankZero));
    }
  }
  return true;
}

bool EliminationRecorder::run() {
  constexpr std::size_t kMostColumns = 1000;  // a larger one takes longer to record than to solve
  if (columns_.size() > kMostColumns) {
    return false;
  }
  while (!open_.empty()) {
    if (!pivot_once()) {
      return false;
    }
  }
  return demand_surplus();
}

// All of them, of which the tape keeps what is needed.
std::vector<TapeNumber> EliminationRecorder::substitute(std::span<const int> wanted) {
  for (auto pivot = pivots_.rbegin(); pivot != pivots_.rend(); ++pivot) {
    std::vector<LaneRecorder::Product> products;
    for (const auto& [column, value] : at(rows_, pivot->row)) {
      if (column != pivot->column) {
        products.push_back({.a = value, .b = unknowns_.at(column)});
      }
    }
    unknowns_[pivot->column] =
        recorder_.substitute(products, at(rows_, pivot->row).at(pivot->column));
  }
  std::vector<TapeNumber> result;
  for (const int column : wanted) {
    result.push_back(
        recorder_.multiply(unknowns_.at(column), recorder_.constant(at(scaling_.columns, column))));
  }
  return result;
}

}  // namespace

std::optional<std::vector<TapeNumber>> record_elimination(const TapedMatrix& matrix,
                                                          std::span<const TapedUnknown> known,
                                                          std::span<const int> wanted,
                                                          LaneRecorder& recorder) {
  EliminationRecorder elimination(matrix, known, recorder);
  return elimination.run() ? std::optional(elimination.substitute(wanted)) : std::nullopt;
}

}  // namespace kinestat
