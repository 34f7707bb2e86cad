#include "math/elimination/exact_elimination.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "math/elimination/internal/field_eliminator.hpp"
#include "math/elimination/internal/field_solve.hpp"
#include "math/elimination/internal/rational_field.hpp"

namespace kinestat {

struct ExactElimination::Factors {
  FieldElimination<RationalField> elimination;
  std::vector<int> last;
  int columns = 0;
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

ExactSolution ExactElimination::solve(std::span<const Rational> known,
                                      std::span<const Rational> rhs) const {
  KINESTAT_EXPECTS(known.size() == factors_->last.size());
  ExactSolution solution;
  solution.x.resize(static_cast<std::size_t>(factors_->columns));
  for (std::size_t i = 0; i < known.size(); ++i) {
    at(solution.x, factors_->last[i]) = known[i];
  }
  const FieldElimination<RationalField>& elimination = factors_->elimination;
  KINESTAT_EXPECTS(rhs.empty() || rhs.size() == elimination.rows.size());
  const std::vector<Rational> right = eliminated<RationalField>(elimination, rhs);
  back_substitute<RationalField>(elimination, right, solution.x);
  const std::vector<Rational> left =
      left_by_surplus_rows<RationalField>(elimination, right, solution.x);
  solution.consistent =
      std::ranges::all_of(left, [](const Rational& one) { return one.is_zero(); });
  return solution;
}

std::vector<std::vector<Rational>> ExactElimination::null_vectors() const {
  std::vector<std::vector<Rational>> result;
  for (const int column : factors_->elimination.free_columns) {
    std::vector<Rational> x(static_cast<std::size_t>(factors_->columns));
    at(x, column) = 1;
    back_substitute<RationalField>(factors_->elimination, {}, x);
    result.push_back(std::move(x));
  }
  return result;
}

}  // namespace kinestat
