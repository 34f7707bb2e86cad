#include "math/elimination/elimination.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "math/elimination/internal/eliminator.hpp"
#include "math/tapes/internal/at.hpp"

namespace kinestat {

Elimination::Elimination(SparseMatrix matrix, std::span<const int> last)
    : matrix_(std::move(matrix)), scaling_(find_scaling(matrix_)), last_(last.begin(), last.end()) {
  std::vector<int> known = last_;
  Eliminator(*this).run();
  last_ = std::move(known);
}

// A combination of eliminated rows as one of the scaled rows of A.
VecX Elimination::combined_rows(VecX eliminated) const {
  VecX size = eliminated.cwiseAbs();
  for (auto step = multipliers_.rbegin(); step != multipliers_.rend(); ++step) {
    const double term = step->value * eliminated[step->row];
    double& value = eliminated[step->pivot_row];
    value -= term;
    size[step->pivot_row] += std::abs(term);
    value = std::abs(value) <= kCancellation * size[step->pivot_row] ? 0.0 : value;
  }
  return eliminated;
}

std::vector<int> Elimination::equations_of(const Pivot& pivot) const {
  const VecX weights = combined_rows(VecX::Unit(matrix_.rows, pivot.row));
  const double largest = weights.cwiseAbs().maxCoeff();
  std::vector<int> equations;
  for (int r = 0; r < matrix_.rows; ++r) {
    if (std::abs(weights[r]) > kRankZero * largest) {
      equations.push_back(r);
    }
  }
  return equations;
}

std::vector<Relation> Elimination::relations(std::span<const double> rhs) const {
  const EliminatedRows right = eliminate_rows(rhs);
  std::vector<Relation> result;
  for (const Pivot& pivot : last_pivots_) {
    Relation relation;
    relation.equations = equations_of(pivot);
    if (!rhs.empty()) {
      relation.constant = at(right.values, pivot.row);
      relation.constant_size = at(right.sizes, pivot.row);
    }
    // A short row is chosen even where its pivot is small: what is as large is no rounding of it.
    const double zero = std::min(kRankZero, kPivotShare * std::abs(pivot.value));
    for (const Cell& cell : at(rows_, pivot.row)) {
      if (std::abs(cell.value) > zero && std::ranges::find(last_, cell.column) != last_.end()) {
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

double Elimination::residual(const VecX& x, std::span<const double> rhs) const {
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
bool Elimination::surplus_rows_hold(const VecX& scaled_x, const EliminatedRows& right) const {
  std::vector<bool> has_pivot(rows_.size(), false);
  for (const Pivot& pivot : pivots_) {
    at(has_pivot, pivot.row) = true;
  }
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    if (has_pivot[r]) {
      continue;
    }
    double sum = right.values.empty() ? 0.0 : -right.values[r];
    double size = right.sizes.empty() ? 0.0 : right.sizes[r];
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

VecX Elimination::scaled_known(std::span<const double> known) const {
  KINESTAT_EXPECTS(known.size() == last_.size());
  VecX x = VecX::Zero(matrix_.columns);
  for (std::size_t i = 0; i < known.size(); ++i) {
    x[last_[i]] = known[i] / at(scaling_.columns, last_[i]);
  }
  return x;
}

// A difference that is mere rounding becomes an exact zero, as in the rows of the matrix.
Elimination::EliminatedRows Elimination::eliminate_rows(std::span<const double> rhs) const {
  KINESTAT_EXPECTS(rhs.empty() || rhs.size() == static_cast<std::size_t>(matrix_.rows));
  EliminatedRows right{.values = std::vector<double>(rhs.size()),
                       .sizes = std::vector<double>(rhs.size())};
  for (std::size_t r = 0; r < rhs.size(); ++r) {
    right.values[r] = rhs[r] * scaling_.rows[r];
    right.sizes[r] = std::abs(right.values[r]);
  }
  if (!rhs.empty()) {
    for (const Multiplier& step : multipliers_) {
      double& value = at(right.values, step.row);
      const double term = step.value * at(right.values, step.pivot_row);
      const double size = std::abs(value) + std::abs(term);
      value -= term;
      value = std::abs(value) <= kCancellation * size ? 0.0 : value;
      at(right.sizes, step.row) += std::abs(step.value) * at(right.sizes, step.pivot_row);
    }
  }
  return right;
}

EliminationSolution Elimination::solve(std::span<const double> known,
                                       std::span<const double> rhs) const {
  EliminationSolution solution{.x = scaled_known(known), .residual = 0.0, .consistent = true};
  const EliminatedRows right = eliminate_rows(rhs);
  back_substitute(right.values, solution.x);
  solution.consistent = surplus_rows_hold(solution.x, right);
  unscale(solution.x);
  solution.residual = residual(solution.x, rhs);
  return solution;
}

bool Elimination::is_consistent(std::span<const double> known, std::span<const double> rhs) const {
  const bool has_surplus = pivots_.size() < rows_.size();
  return !has_surplus || surplus_rows_hold(scaled_known(known), eliminate_rows(rhs));
}

AdjointSolution Elimination::solve_adjoint(const VecX& gradient) const {
  KINESTAT_EXPECTS(gradient.size() == matrix_.columns);
  VecX left = gradient;
  for (int c = 0; c < matrix_.columns; ++c) {
    left[c] *= at(scaling_.columns, c);
  }
  VecX size = left.cwiseAbs();
  VecX rows = VecX::Zero(matrix_.rows);
  for (const Pivot& pivot : pivots_) {
    const bool is_rounding = std::abs(left[pivot.column]) <= kCancellation * size[pivot.column];
    const double y = is_rounding ? 0.0 : left[pivot.column] / pivot.value;
    rows[pivot.row] = y;
    for (const Cell& cell : at(rows_, pivot.row)) {
      left[cell.column] -= cell.value * y;
      size[cell.column] += std::abs(cell.value * y);
    }
  }
  rows = combined_rows(std::move(rows));
  for (int r = 0; r < matrix_.rows; ++r) {
    rows[r] *= at(scaling_.rows, r);
  }
  AdjointSolution solution{.rows = std::move(rows),
                           .known = VecX::Zero(static_cast<Eigen::Index>(last_.size()))};
  for (std::size_t i = 0; i < last_.size(); ++i) {
    const int c = last_[i];
    const bool is_rounding = std::abs(left[c]) <= kCancellation * size[c];
    solution.known[static_cast<Eigen::Index>(i)] =
        is_rounding ? 0.0 : left[c] / at(scaling_.columns, c);
  }
  return solution;
}

VecX Elimination::most_change(const VecX& errors) const {
  // What rounding leaves out of sums of what is not negative is far less.
  constexpr double kOutwards = 1.0 + 0x1p-20;
  VecX right(errors.size());
  for (int r = 0; r < matrix_.rows; ++r) {
    right[r] = errors[r] * at(scaling_.rows, r);
  }
  for (const Multiplier& step : multipliers_) {
    right[step.row] += std::abs(step.value) * right[step.pivot_row];
  }
  VecX x = VecX::Zero(matrix_.columns);
  for (auto pivot = pivots_.rbegin(); pivot != pivots_.rend(); ++pivot) {
    double sum = right[pivot->row];
    for (const Cell& cell : at(rows_, pivot->row)) {
      sum += std::abs(cell.value) * x[cell.column];
    }
    x[pivot->column] = kOutwards * sum / std::abs(pivot->value);
  }
  unscale(x);
  return x;
}

void Elimination::unscale(VecX& x) const {
  for (int c = 0; c < matrix_.columns; ++c) {
    x[c] *= at(scaling_.columns, c);
  }
}

std::vector<int> Elimination::pivot_rows() const {
  std::vector<int> rows;
  for (const Pivot& pivot : pivots_) {
    rows.push_back(pivot.row);
  }
  std::ranges::sort(rows);
  return rows;
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

VecX Elimination::mixed_null_vector() const {
  std::mt19937_64 random(free_columns_.size());
  VecX x = VecX::Zero(matrix_.columns);
  for (const int column : free_columns_) {
    // From 1 to 2, in steps of 2^-52.
    const double weight = 1.0 + std::ldexp(static_cast<double>(random() >> 12U), -52);
    x[column] = weight / at(scaling_.columns, column);
  }
  back_substitute({}, x);
  unscale(x);
  return x;
}

}  // namespace kinestat
