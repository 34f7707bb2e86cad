#include "math/elimination/internal/eliminator.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <tuple>

#include "core/tolerance.hpp"
#include "math/tapes/internal/at.hpp"

namespace kinestat {

namespace {

constexpr std::size_t kShortRow = 32;

// Cells of the same column stay in their order. A long row needs a buffer for that.
template <class Row>
void sort_by_column(Row& row) {
  const auto by_column = [](const auto& a, const auto& b) { return a.column < b.column; };
  if (row.size() > kShortRow) {
    std::ranges::stable_sort(row, by_column);
    return;
  }
  for (auto cell = row.begin(); cell != row.end(); ++cell) {
    std::rotate(std::upper_bound(row.begin(), cell, *cell, by_column), cell, cell + 1);
  }
}

}  // namespace

Eliminator::Eliminator(Elimination& result) : out_(result), rows_(result.rows_) {
  load();
}

void Eliminator::run() {
  std::vector<int> first;
  std::vector<bool> is_last(columns_.size(), false);
  for (const int c : out_.last_) {
    at(is_last, c) = true;
  }
  for (int c = 0; c < out_.matrix_.columns; ++c) {
    if (!is_last[static_cast<std::size_t>(c)]) {
      first.push_back(c);
    }
  }
  out_.pivots_.reserve(std::min(rows_.size(), first.size()));
  eliminate(first, out_.pivots_);
  out_.free_columns_ = first;
  std::ranges::sort(out_.free_columns_);
  eliminate(out_.last_, out_.last_pivots_);
  out_.evidence_.rank = static_cast<int>(out_.pivots_.size() + out_.last_pivots_.size());
  out_.evidence_.method = "sparse elimination";
  if (out_.evidence_.rank == 0) {
    out_.evidence_.smallest_pivot = 0.0;
  }
}

// Scales the entries, adds those at the same place and sorts each row by column.
void Eliminator::load() {
  const SparseMatrix& matrix = out_.matrix_;
  rows_.assign(static_cast<std::size_t>(matrix.rows), {});
  columns_.assign(static_cast<std::size_t>(matrix.columns), {});
  counts_.assign(columns_.size(), 0);
  active_.assign(rows_.size(), true);
  reserve(matrix);
  for (const SparseEntry& entry : matrix.entries) {
    const double value =
        entry.value * at(out_.scaling_.rows, entry.row) * at(out_.scaling_.columns, entry.column);
    at(rows_, entry.row).push_back({.column = entry.column, .value = value});
  }
  for (int r = 0; r < matrix.rows; ++r) {
    sort_and_add(at(rows_, r));
    for (const Cell& cell : at(rows_, r)) {
      enter(r, cell.column);
    }
  }
}

// Room for the entries; what fills in later is little in most mechanisms.
void Eliminator::reserve(const SparseMatrix& matrix) {
  std::vector<std::size_t> in_row(rows_.size(), 0);
  std::vector<std::size_t> in_column(columns_.size(), 0);
  for (const SparseEntry& entry : matrix.entries) {
    ++at(in_row, entry.row);
    ++at(in_column, entry.column);
  }
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    rows_[r].reserve(in_row[r]);
  }
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    columns_[c].reserve(in_column[c]);
  }
  out_.multipliers_.reserve(matrix.entries.size());
}

void Eliminator::sort_and_add(Row& row) {
  if (!std::ranges::is_sorted(row, {}, &Cell::column)) {
    sort_by_column(row);
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (kept > 0 && row[kept - 1].column == row[i].column) {
      row[kept - 1].value += row[i].value;
    } else {
      row[kept++] = row[i];
    }
  }
  row.resize(kept);
  std::erase_if(row, [](const Cell& cell) { return cell.value == 0.0; });
}

void Eliminator::enter(int row, int column) {
  at(columns_, column).push_back(row);
  count(column, 1);
}

void Eliminator::count(int column, int change) {
  at(counts_, column) += change;
  if (queue_ != nullptr) {
    queue_->tell(column);
  }
}

double Eliminator::value_at(int row, int column) const {
  const Row& cells = at(rows_, row);
  const auto found = std::ranges::lower_bound(cells, column, {}, &Cell::column);
  return found != cells.end() && found->column == column ? found->value : 0.0;
}

// The sparsest active row whose entry is at least kPivotShare of the largest; also forgets the
// rows that no longer hold the column.
Eliminator::Choice Eliminator::choose_row(int column) {
  std::vector<int>& rows = at(columns_, column);
  Choice choice;
  values_.clear();
  std::erase_if(rows, [&](int r) {
    const double value = at(active_, r) ? value_at(r, column) : 0.0;
    if (value != 0.0) {
      values_.push_back(value);
      choice.largest = std::max(choice.largest, std::abs(value));
    }
    return value == 0.0;
  });
  std::size_t shortest = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t length = at(rows_, rows[i]).size();
    const bool is_better = choice.row < 0 || length < shortest;
    if (is_better && std::abs(values_[i]) >= kPivotShare * choice.largest) {
      choice.row = rows[i];
      choice.value = values_[i];
      shortest = length;
    }
  }
  return choice;
}

// Pivots on the candidates until none is left; those that found no pivot stay in `candidates`.
void Eliminator::eliminate(std::vector<int>& candidates, std::vector<Elimination::Pivot>& pivots) {
  std::vector<int> waiting;
  std::vector<int> without;
  ColumnQueue queue(std::move(candidates), counts_);
  queue_ = &queue;
  while (const std::optional<int> column = queue.take_least()) {
    const Choice choice = choose_row(*column);
    if (choice.largest < kPivotWaits) {
      (choice.row < 0 ? without : waiting).push_back(*column);
    } else {
      pivot_on(*column, choice, pivots);
    }
  }
  queue_ = nullptr;
  settle(waiting, without, pivots);
  candidates = std::move(without);
}

// The columns whose entries are small: the largest first, until what remains counts as zero. A
// pivot changes the entries of the columns of its row and no others.
void Eliminator::settle(std::vector<int>& waiting,
                        std::vector<int>& without,
                        std::vector<Elimination::Pivot>& pivots) {
  if (waiting.empty()) {
    return;
  }
  std::vector<double> largest(columns_.size(), -1.0);
  std::set<std::tuple<double, std::size_t, int>> order;
  std::vector<std::size_t> place(columns_.size(), 0);
  const auto enter_column = [&](int column) {
    at(largest, column) = choose_row(column).largest;
    order.emplace(-at(largest, column), at(place, column), column);
  };
  for (std::size_t i = 0; i < waiting.size(); ++i) {
    at(place, waiting[i]) = i;
    enter_column(waiting[i]);
  }
  while (!order.empty()) {
    const int column = std::get<int>(*order.begin());
    if (at(largest, column) <= kRankZero) {
      out_.evidence_.largest_dropped =
          std::max(out_.evidence_.largest_dropped, at(largest, column));
      std::ranges::copy_if(
          waiting, std::back_inserter(without), [&](int c) { return at(largest, c) >= 0.0; });
      return;
    }
    order.erase(order.begin());
    at(largest, column) = -1.0;
    const Choice choice = choose_row(column);
    pivot_on(column, choice, pivots);
    for (const Cell& cell : at(rows_, choice.row)) {
      if (at(largest, cell.column) >= 0.0) {
        order.erase({-at(largest, cell.column), at(place, cell.column), cell.column});
        enter_column(cell.column);
      }
    }
  }
}

void Eliminator::pivot_on(int column,
                          const Choice& choice,
                          std::vector<Elimination::Pivot>& pivots) {
  at(active_, choice.row) = false;
  for (const Cell& cell : at(rows_, choice.row)) {
    count(cell.column, -1);
  }
  // A row whose entry was lost and filled in again is listed twice; the second time it is 0.
  for (const int r : at(columns_, column)) {
    const double value = r == choice.row ? 0.0 : value_at(r, column);
    if (value != 0.0) {
      subtract(r, choice.row, column, value / choice.value);
    }
  }
  pivots.push_back({.row = choice.row, .column = column, .value = choice.value});
  const double size = std::abs(choice.value);
  double& smallest = out_.evidence_.smallest_pivot;
  smallest = smallest == 0.0 ? size : std::min(smallest, size);
}

// row -= multiplier · pivot row. A difference that is mere rounding becomes an exact zero.
void Eliminator::subtract(int row, int pivot_row, int column, double multiplier) {
  const Row& a = at(rows_, row);
  const Row& b = at(rows_, pivot_row);
  merged_.clear();
  std::size_t i = 0;
  for (const Cell& cell : b) {
    while (i < a.size() && a[i].column < cell.column) {
      merged_.push_back(a[i++]);
    }
    const double term = multiplier * cell.value;
    if (i == a.size() || a[i].column != cell.column) {
      merged_.push_back({.column = cell.column, .value = -term});
      enter(row, cell.column);
      continue;
    }
    const double difference = a[i].value - term;
    const double size = std::abs(a[i].value) + std::abs(term);
    ++i;
    if (cell.column == column || std::abs(difference) <= kCancellation * size) {
      out_.has_dropped_ |= cell.column != column && difference != 0.0;
      count(cell.column, -1);
    } else {
      merged_.push_back({.column = cell.column, .value = difference});
    }
  }
  merged_.insert(merged_.end(), a.begin() + static_cast<std::ptrdiff_t>(i), a.end());
  at(rows_, row).swap(merged_);
  out_.multipliers_.push_back({.row = row, .pivot_row = pivot_row, .value = multiplier});
}

}  // namespace kinestat
