#include "math/internal/tape_recorder.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "math/internal/at.hpp"

namespace kinestat {

namespace {

// What is zero here alone says nothing about the size of its row.
SparseMatrix without_zeros(SparseMatrix matrix) {
  std::erase_if(matrix.entries, [](const SparseEntry& entry) { return entry.value == 0.0; });
  return matrix;
}

}  // namespace

TapeRecorder::TapeRecorder(const SparseMatrix& matrix,
                           const std::vector<bool>& varies,
                           std::span<const int> last)
    : rows_(static_cast<std::size_t>(matrix.rows)),
      columns_(static_cast<std::size_t>(matrix.columns)),
      active_(rows_.size(), true),
      varies_(varies) {
  tape_.scaling_ = find_scaling(without_zeros(matrix));
  tape_.last_.assign(last.begin(), last.end());
  for (const SparseEntry& entry : matrix.entries) {
    const double scale =
        at(tape_.scaling_.rows, entry.row) * at(tape_.scaling_.columns, entry.column);
    const bool is_new =
        at(rows_, entry.row).emplace(entry.column, static_cast<int>(tape_.cells_.size())).second;
    KINESTAT_EXPECTS(is_new);
    at(columns_, entry.column).insert(entry.row);
    tape_.scale_.push_back(scale);
    tape_.cells_.push_back(entry.value * scale);
  }
  values_ = tape_.cells_;
  for (int c = 0; c < matrix.columns; ++c) {
    if (std::ranges::find(last, c) == last.end()) {
      open_.push_back(c);
    }
  }
}

double TapeRecorder::size_of(int cell) const {
  return std::abs(at(values_, cell));
}

// The sparsest row with a sufficient entry; false where all are small.
bool TapeRecorder::choose(int column, Pivot& pivot) const {
  double largest = 0.0;
  for (const int r : at(columns_, column)) {
    largest = std::max(largest, size_of(at(rows_, r).at(column)));
  }
  if (largest < kSafePivot) {
    return false;
  }
  std::size_t shortest = 0;
  bool is_found = false;
  for (const int r : at(columns_, column)) {
    const Row& row = at(rows_, r);
    const int cell = row.at(column);
    if (size_of(cell) >= kPivotShare * largest && (!is_found || row.size() < shortest)) {
      pivot = {.row = r, .column = column, .cell = cell};
      shortest = row.size();
      is_found = true;
    }
  }
  return is_found;
}

// On the column with the fewest entries of those that have a good one.
bool TapeRecorder::pivot_once() {
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

void TapeRecorder::eliminate(const Pivot& pivot) {
  at(active_, pivot.row) = false;
  if (at(varies_, pivot.cell)) {
    tape_.pivots_.push_back(pivot.cell);
  }
  for (const auto& [column, cell] : at(rows_, pivot.row)) {
    at(columns_, column).erase(pivot.row);
  }
  const std::set<int> others = at(columns_, pivot.column);
  for (const int r : others) {
    subtract(r, pivot);
  }
  pivots_.push_back(pivot);
}

// Steps that touch nothing that varies are done here, once and for all.
void TapeRecorder::subtract(int row, const Pivot& pivot) {
  Row& target = at(rows_, row);
  const int entry = target.at(pivot.column);
  const double factor = at(values_, entry) / at(values_, pivot.cell);
  const bool varies = at(varies_, entry) || at(varies_, pivot.cell);
  EliminationTape::Subtraction one{
      .entry = entry, .pivot = pivot.cell, .first_step = static_cast<int>(tape_.steps_.size())};
  target.erase(pivot.column);
  at(columns_, pivot.column).erase(row);
  std::vector<EliminationTape::Step> fills;
  for (const auto& [column, cell] : at(rows_, pivot.row)) {
    const auto present = target.find(column);
    if (column == pivot.column) {
      continue;
    }
    if (present == target.end()) {
      const EliminationTape::Step fill{.target = fill_in(target, column), .source = cell};
      at(columns_, column).insert(row);
      if (step(fill, factor, varies, true)) {
        fills.push_back(fill);
      }
    } else if (step({.target = present->second, .source = cell}, factor, varies, false)) {
      tape_.steps_.push_back({.target = present->second, .source = cell});
    }
  }
  one.first_fill = static_cast<int>(tape_.steps_.size());
  tape_.steps_.insert(tape_.steps_.end(), fills.begin(), fills.end());
  one.end = static_cast<int>(tape_.steps_.size());
  if (one.end > one.first_step || varies) {
    tape_.subtractions_.push_back(one);
  }
}

int TapeRecorder::fill_in(Row& row, int column) {
  const int cell = static_cast<int>(values_.size());
  row.emplace(column, cell);
  values_.push_back(0.0);
  tape_.cells_.push_back(0.0);
  varies_.push_back(false);
  return cell;
}

// Answers whether it must be played again for another matrix.
bool TapeRecorder::step(EliminationTape::Step step, double factor, bool varies, bool is_fill) {
  const double term = factor * at(values_, step.source);
  double& value = at(values_, step.target);
  value = is_fill ? -term : without_rounding(value, term);
  const auto target = static_cast<std::size_t>(step.target);
  varies_[target] = varies_[target] || varies || at(varies_, step.source);
  if (!varies_[target]) {
    tape_.cells_[target] = value;
  }
  return varies_[target];
}

// Rows that have no pivot follow from the others, up to rounding.
bool TapeRecorder::surplus_has_vanished() {
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    for (const auto& [column, cell] : rows_[r]) {
      if (active_[r] && size_of(cell) > kRankZero) {
        return false;
      }
      if (active_[r] && at(varies_, cell)) {
        tape_.surplus_.push_back(cell);
      }
    }
  }
  return true;
}

// What is wanted, and what that needs: the columns of its row that have their pivots later.
void TapeRecorder::record_substitutions(std::span<const int> wanted) {
  std::set<int> needed(wanted.begin(), wanted.end());
  std::vector<Pivot> used;
  for (const Pivot& pivot : pivots_) {
    if (needed.contains(pivot.column)) {
      used.push_back(pivot);
      for (const auto& [column, cell] : at(rows_, pivot.row)) {
        needed.insert(column);
      }
    }
  }
  for (auto pivot = used.rbegin(); pivot != used.rend(); ++pivot) {
    EliminationTape::Substitution one{.column = pivot->column,
                                      .pivot = pivot->cell,
                                      .first_term = static_cast<int>(tape_.terms_.size())};
    for (const auto& [column, cell] : at(rows_, pivot->row)) {
      if (column != pivot->column) {
        tape_.terms_.push_back({.cell = cell, .column = column});
      }
    }
    one.end = static_cast<int>(tape_.terms_.size());
    tape_.substitutions_.push_back(one);
  }
}

bool TapeRecorder::run(std::span<const int> wanted) {
  constexpr std::size_t kMostColumns = 1000;  // a larger one takes longer to record than to solve
  if (columns_.size() > kMostColumns) {
    return false;
  }
  while (!open_.empty()) {
    if (!pivot_once()) {
      return false;
    }
  }
  if (!surplus_has_vanished()) {
    return false;
  }
  record_substitutions(wanted);
  return true;
}

}  // namespace kinestat
