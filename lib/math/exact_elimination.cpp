#include "math/exact_elimination.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "math/internal/field_eliminator.hpp"
#include "math/internal/rational_field.hpp"

namespace kinestat {

namespace {

using Rows = std::vector<FieldElimination<RationalField>::Row>;

// sum -= row · x.
void subtract_terms(const Rows& rows, int row, const std::vector<Rational>& x, Rational& sum) {
  RationalField field;
  for (const auto& cell : at(rows, row)) {
    const Rational& factor = at(x, cell.column);
    if (!factor.is_zero()) {
      field.subtract_product(sum, cell.value, factor);
    }
  }
}

}  // namespace

struct ExactElimination::Factors {
  FieldElimination<RationalField> elimination;
  std::vector<int> last;
  int columns = 0;

  void back_substitute(std::span<const Rational> rhs, std::vector<Rational>& x) const;
  std::vector<Rational> eliminate(std::span<const Rational> rhs) const;
  bool surplus_rows_hold(std::span<const Rational> right, const std::vector<Rational>& x) const;
};

ExactMatrix exact_matrix(const SparseMatrix& matrix) {
  ExactMatrix result{.rows = matrix.rows, .columns = matrix.columns, .entries = {}};
  result.entries.reserve(matrix.entries.size());
  KINESTAT_EXPECTS(std::ranges::all_of(
      matrix.entries, [](const SparseEntry& entry) { return std::isfinite(entry.value); }));
  for (const SparseEntry& entry : matrix.entries) {
    result.entries.push_back(
        {.row = entry.row, .column = entry.column, .value = Rational(entry.value)});
  }
  return result;
}

ExactElimination::ExactElimination(const ExactMatrix& matrix, std::span<const int> last)
    : factors_(std::make_unique<Factors>()) {
  factors_->columns = matrix.columns;
  factors_->last.assign(last.begin(), last.end());
  factors_->elimination.load(
      matrix.rows, matrix.entries, [](const Rational& value) { return value; });
  FieldEliminator(factors_->elimination, matrix.columns).run(last);
}

ExactElimination::~ExactElimination() = default;
ExactElimination::ExactElimination(ExactElimination&& other) noexcept = default;
ExactElimination& ExactElimination::operator=(ExactElimination&& other) noexcept = default;

int ExactElimination::rank() const {
  return factors_->elimination.rank();
}

const std::vector<int>& ExactElimination::free_columns() const {
  return factors_->elimination.free_columns;
}

int ExactElimination::relation_count() const {
  return static_cast<int>(factors_->elimination.last_pivots.size());
}

// The right-hand side after the steps of the elimination; empty stands for zero.
std::vector<Rational> ExactElimination::Factors::eliminate(std::span<const Rational> rhs) const {
  KINESTAT_EXPECTS(rhs.empty() || rhs.size() == elimination.rows.size());
  std::vector<Rational> right(rhs.begin(), rhs.end());
  if (rhs.empty()) {
    return right;
  }
  RationalField field;
  for (const auto& step : elimination.steps) {
    const Rational& pivot = at(right, step.pivot_row);
    if (!pivot.is_zero()) {
      field.subtract_product(at(right, step.row), step.multiplier, pivot);
    }
  }
  return right;
}

// x of the pivot's own column is still 0.
void ExactElimination::Factors::back_substitute(std::span<const Rational> rhs,
                                                std::vector<Rational>& x) const {
  for (auto pivot = elimination.pivots.rbegin(); pivot != elimination.pivots.rend(); ++pivot) {
    Rational sum = rhs.empty() ? Rational() : rhs[static_cast<std::size_t>(pivot->row)];
    subtract_terms(elimination.rows, pivot->row, x, sum);
    at(x, pivot->column) = sum.is_zero() ? sum : Rational(sum / pivot->value);
  }
}

// What is left of rows without a pivot outside `last` holds columns of `last` alone.
bool ExactElimination::Factors::surplus_rows_hold(std::span<const Rational> right,
                                                  const std::vector<Rational>& x) const {
  std::vector<bool> has_pivot(elimination.rows.size(), false);
  for (const auto& pivot : elimination.pivots) {
    at(has_pivot, pivot.row) = true;
  }
  for (std::size_t r = 0; r < has_pivot.size(); ++r) {
    if (has_pivot[r]) {
      continue;
    }
    Rational sum = right.empty() ? Rational() : right[r];
    subtract_terms(elimination.rows, static_cast<int>(r), x, sum);
    if (!sum.is_zero()) {
      return false;
    }
  }
  return true;
}

ExactSolution ExactElimination::solve(std::span<const Rational> known,
                                      std::span<const Rational> rhs) const {
  KINESTAT_EXPECTS(known.size() == factors_->last.size());
  ExactSolution solution;
  solution.x.resize(static_cast<std::size_t>(factors_->columns));
  for (std::size_t i = 0; i < known.size(); ++i) {
    at(solution.x, factors_->last[i]) = known[i];
  }
  const std::vector<Rational> right = factors_->eliminate(rhs);
  factors_->back_substitute(right, solution.x);
  solution.consistent = factors_->surplus_rows_hold(right, solution.x);
  return solution;
}

std::vector<std::vector<Rational>> ExactElimination::null_vectors() const {
  std::vector<std::vector<Rational>> result;
  for (const int column : factors_->elimination.free_columns) {
    std::vector<Rational> x(static_cast<std::size_t>(factors_->columns));
    at(x, column) = 1;
    factors_->back_substitute({}, x);
    result.push_back(std::move(x));
  }
  return result;
}

}  // namespace kinestat
