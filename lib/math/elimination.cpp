#include "math/elimination.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "math/internal/at.hpp"
#include "math/internal/eliminator.hpp"

namespace kinestat {

Elimination::Elimination(SparseMatrix matrix, std::span<const int> last)
    : matrix_(std::move(matrix)), scaling_(find_scaling(matrix_)), last_(last.begin(), last.end()) {
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

// A sum that is mere rounding of its own terms is an exact zero; a small one is kept as it is.
void Elimination::back_substitute(std::span<const double> scaled_rhs, VecX& x) const {
  for (auto pivot = pivots_.rbegin(); pivot != pivots_.rend(); ++pivot) {
    double sum = scaled_rhs.empty() ? 0.0 : scaled_rhs[static_cast<std::size_t>(pivot->row)];
    double size = std::abs(sum);
    for (const Cell& cell : at(rows_, pivot->row)) {
      if (cell.column != pivot->column) {
        const double term = cell.value * x[cell.column];
        sum -= term;
        size += std::abs(term);
      }
    }
    x[pivot->column] = std::abs(sum) <= kCancellation * size ? 0.0 : sum / pivot->value;
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
