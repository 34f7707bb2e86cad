#include "math/elimination.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/contract.hpp"
#include "core/tolerance.hpp"

namespace kinestat {

namespace {

template <class T>
decltype(auto) at(T& container, int i) {
  return container[static_cast<std::size_t>(i)];
}

}  // namespace

/// Carries the working state of one elimination; what survives goes into its Elimination.
class Eliminator {
 public:
  explicit Eliminator(Elimination& result) : out_(result), rows_(result.rows_) { load(); }

  void run() {
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

 private:
  using Cell = Elimination::Cell;
  using Row = std::vector<Cell>;

  struct Column {
    std::vector<int> rows;  ///< may name rows that are done or have lost the entry
    int count = 0;          ///< entries in active rows
  };

  struct Choice {
    int row = -1;
    double value = 0.0;    ///< of the pivot
    double largest = 0.0;  ///< magnitude in the column
  };

  // Scales the entries, adds those at the same place and sorts each row by column.
  void load() {
    const SparseMatrix& matrix = out_.matrix_;
    rows_.assign(static_cast<std::size_t>(matrix.rows), {});
    columns_.assign(static_cast<std::size_t>(matrix.columns), {});
    active_.assign(rows_.size(), true);
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

  static void sort_and_add(Row& row) {
    const auto by_column = [](const Cell& a, const Cell& b) { return a.column < b.column; };
    if (!std::ranges::is_sorted(row, by_column)) {
      std::ranges::stable_sort(row, by_column);
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

  void enter(int row, int column) {
    at(columns_, column).rows.push_back(row);
    ++at(columns_, column).count;
  }

  double value_at(int row, int column) const {
    const Row& cells = at(rows_, row);
    const auto found = std::ranges::lower_bound(cells, column, {}, &Cell::column);
    return found != cells.end() && found->column == column ? found->value : 0.0;
  }

  // The sparsest active row whose entry is at least kPivotShare of the largest; also forgets the
  // rows that no longer hold the column.
  Choice choose_row(int column) {
    std::vector<int>& rows = at(columns_, column).rows;
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
  void eliminate(std::vector<int>& candidates, std::vector<Elimination::Pivot>& pivots) {
    std::vector<int> waiting;
    std::vector<int> without;
    while (!candidates.empty()) {
      const auto best =
          std::ranges::min_element(candidates, {}, [&](int c) { return at(columns_, c).count; });
      const int column = *best;
      candidates.erase(best);
      const Choice choice = choose_row(column);
      if (choice.largest < kPivotWaits) {
        (choice.row < 0 ? without : waiting).push_back(column);
      } else {
        pivot_on(column, choice, pivots);
      }
    }
    settle(waiting, without, pivots);
    candidates = std::move(without);
  }

  // The columns whose entries are small: the largest first, until what remains counts as zero.
  void settle(std::vector<int>& waiting,
              std::vector<int>& without,
              std::vector<Elimination::Pivot>& pivots) {
    while (!waiting.empty()) {
      std::size_t best = 0;
      Choice choice;
      for (std::size_t i = 0; i < waiting.size(); ++i) {
        const Choice candidate = choose_row(waiting[i]);
        if (i == 0 || candidate.largest > choice.largest) {
          best = i;
          choice = candidate;
        }
      }
      if (choice.largest <= kRankZero) {
        out_.evidence_.largest_dropped = std::max(out_.evidence_.largest_dropped, choice.largest);
        without.insert(without.end(), waiting.begin(), waiting.end());
        return;
      }
      const int column = waiting[best];
      waiting.erase(waiting.begin() + static_cast<std::ptrdiff_t>(best));
      pivot_on(column, choice, pivots);
    }
  }

  void pivot_on(int column, const Choice& choice, std::vector<Elimination::Pivot>& pivots) {
    at(active_, choice.row) = false;
    for (const Cell& cell : at(rows_, choice.row)) {
      --at(columns_, cell.column).count;
    }
    // A row whose entry was lost and filled in again is listed twice; the second time it is 0.
    for (const int r : at(columns_, column).rows) {
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
  void subtract(int row, int pivot_row, int column, double multiplier) {
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
        --at(columns_, cell.column).count;
      } else {
        merged_.push_back({.column = cell.column, .value = difference});
      }
    }
    merged_.insert(merged_.end(), a.begin() + static_cast<std::ptrdiff_t>(i), a.end());
    at(rows_, row).swap(merged_);
    out_.multipliers_.push_back({.row = row, .pivot_row = pivot_row, .value = multiplier});
  }

  Elimination& out_;
  std::vector<Row>& rows_;
  std::vector<Column> columns_;
  std::vector<bool> active_;
  std::vector<double> values_;  ///< of choose_row
  Row merged_;                  ///< of subtract
};

Elimination::Elimination(const SparseMatrix& matrix, std::span<const int> last)
    : matrix_(matrix), scaling_(find_scaling(matrix)), last_(last.begin(), last.end()) {
  std::vector<int> known = last_;
  Eliminator(*this).run();
  last_ = std::move(known);
}

std::vector<Relation> Elimination::relations() const {
  std::vector<Relation> result;
  for (const Pivot& pivot : last_pivots_) {
    Relation relation;
    for (const Cell& cell : at(rows_, pivot.row)) {
      const bool counts = std::abs(cell.value) > kRankZero;
      if (counts && std::ranges::find(last_, cell.column) != last_.end()) {
        relation.terms.push_back({.row = 0,
                                  .column = cell.column,
                                  .value = cell.value / at(scaling_.columns, cell.column)});
      }
    }
    result.push_back(std::move(relation));
  }
  return result;
}

void Elimination::back_substitute(std::span<const double> scaled_rhs, VecX& x) const {
  for (auto pivot = pivots_.rbegin(); pivot != pivots_.rend(); ++pivot) {
    double sum = scaled_rhs.empty() ? 0.0 : scaled_rhs[static_cast<std::size_t>(pivot->row)];
    for (const Cell& cell : at(rows_, pivot->row)) {
      if (cell.column != pivot->column) {
        sum -= cell.value * x[cell.column];
      }
    }
    x[pivot->column] = sum / pivot->value;
  }
}

double Elimination::relative_residual(const VecX& x, std::span<const double> rhs) const {
  std::vector<double> difference(static_cast<std::size_t>(matrix_.rows), 0.0);
  std::vector<double> size(difference.size(), 0.0);
  for (std::size_t r = 0; r < rhs.size(); ++r) {
    difference[r] = -rhs[r];
    size[r] = std::abs(rhs[r]);
  }
  for (const SparseEntry& entry : matrix_.entries) {
    const double term = entry.value * x[entry.column];
    at(difference, entry.row) += term;
    at(size, entry.row) += std::abs(term);
  }
  double largest_difference = 0.0;
  double largest_size = 0.0;
  for (std::size_t r = 0; r < size.size(); ++r) {
    largest_difference = std::max(largest_difference, scaling_.rows[r] * std::abs(difference[r]));
    largest_size = std::max(largest_size, scaling_.rows[r] * size[r]);
  }
  return largest_size == 0.0 ? 0.0 : largest_difference / largest_size;
}

// Rows without a pivot among the unknown columns: what is left of them must vanish, measured
// against all that was summed into them. Entries that counted as zero for the rank are rounding,
// and there is nothing in the row to measure them against.
bool Elimination::surplus_rows_hold(const VecX& scaled_x,
                                    std::span<const double> right,
                                    std::span<const double> sizes) const {
  std::vector<bool> has_pivot(rows_.size(), false);
  for (const Pivot& pivot : pivots_) {
    at(has_pivot, pivot.row) = true;
  }
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    if (has_pivot[r]) {
      continue;
    }
    double sum = right.empty() ? 0.0 : -right[r];
    double size = sizes.empty() ? 0.0 : sizes[r];
    for (const Cell& cell : rows_[r]) {
      const bool counts = std::abs(cell.value) > kRankZero;
      if (counts && std::ranges::find(last_, cell.column) != last_.end()) {
        sum += cell.value * scaled_x[cell.column];
        size += std::abs(cell.value * scaled_x[cell.column]);
      }
    }
    if (std::abs(sum) > kConsistency * size) {
      return false;
    }
  }
  return true;
}

EliminationSolution Elimination::solve(std::span<const double> known,
                                       std::span<const double> rhs) const {
  KINESTAT_EXPECTS(known.size() == last_.size());
  KINESTAT_EXPECTS(rhs.empty() || rhs.size() == static_cast<std::size_t>(matrix_.rows));
  EliminationSolution solution{
      .x = VecX::Zero(matrix_.columns), .residual = 0.0, .consistent = true};
  for (std::size_t i = 0; i < known.size(); ++i) {
    solution.x[last_[i]] = known[i] / at(scaling_.columns, last_[i]);
  }
  std::vector<double> right(rhs.size());
  std::vector<double> sizes(rhs.size());
  for (std::size_t r = 0; r < rhs.size(); ++r) {
    right[r] = rhs[r] * scaling_.rows[r];
    sizes[r] = std::abs(right[r]);
  }
  if (!right.empty()) {
    for (const Multiplier& step : multipliers_) {
      at(right, step.row) -= step.value * at(right, step.pivot_row);
      at(sizes, step.row) += std::abs(step.value) * at(sizes, step.pivot_row);
    }
  }
  back_substitute(right, solution.x);
  solution.consistent = surplus_rows_hold(solution.x, right, sizes);
  unscale(solution.x);
  solution.residual = relative_residual(solution.x, rhs);
  return solution;
}

void Elimination::unscale(VecX& x) const {
  for (int c = 0; c < matrix_.columns; ++c) {
    x[c] *= at(scaling_.columns, c);
  }
}

std::vector<VecX> Elimination::null_vectors() const {
  std::vector<VecX> result;
  for (const int column : free_columns_) {
    VecX x = VecX::Zero(matrix_.columns);
    x[column] = 1.0 / at(scaling_.columns, column);
    back_substitute({}, x);
    unscale(x);
    result.push_back(std::move(x));
  }
  return result;
}

}  // namespace kinestat
