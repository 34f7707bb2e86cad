#include "studies/sensitivity/internal/factored_side.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/rounding.hpp"

namespace kinestat {

namespace {

std::vector<int> columns_of(const std::vector<Primary>& primaries, int first) {
  std::vector<int> columns;
  for (const Primary& primary : primaries) {
    columns.push_back(first + primary.index);
  }
  return columns;
}

}  // namespace

FactoredSide::FactoredSide(CoordinateBasis basis,
                           SparseMatrix system,
                           const std::vector<Primary>& primaries,
                           int first_column,
                           std::vector<double> units)
    : basis_(std::move(basis)),
      system_(std::move(system)),
      elimination_(system_, columns_of(primaries, first_column)),
      first_column_(first_column),
      units_(std::move(units)) {}

std::vector<double> FactoredSide::solve(const Change& right) const {
  return magnitudes_of(elimination_.solve(right.known, right_hand_side(right)).x);
}

AdjointSolution FactoredSide::solve_adjoint(const std::vector<double>& slopes) const {
  VecX gradient = VecX::Zero(system_.columns);
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    gradient[first_column_ + static_cast<int>(i)] = slopes[i] * units_[i];
  }
  return elimination_.solve_adjoint(gradient);
}

std::vector<double> FactoredSide::scaled(std::vector<double> slopes) const {
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    slopes[i] *= units_[i];
  }
  return slopes;
}

VecX FactoredSide::row_errors(const std::vector<double>& magnitudes,
                              std::span<const double> rhs) const {
  VecX x = VecX::Zero(system_.columns);
  for (std::size_t i = 0; i < units_.size(); ++i) {
    x[first_column_ + static_cast<int>(i)] = magnitudes[i] / units_[i];
  }
  return kinestat::row_errors(system_, rhs, blocks(), x);
}

std::vector<double> FactoredSide::bounds(std::span<const std::size_t> wanted,
                                         const std::vector<double>& magnitudes,
                                         std::span<const double> rhs) const {
  const VecX errors = row_errors(magnitudes, rhs);
  const std::vector<int>& open = elimination_.free_columns();
  std::vector<double> result;
  for (const std::size_t i : wanted) {
    const int column = first_column_ + static_cast<int>(i);
    if (std::ranges::binary_search(open, column)) {
      result.push_back(0.0);
      continue;
    }
    const AdjointSolution row = elimination_.solve_adjoint(VecX::Unit(system_.columns, column));
    result.push_back(units_[i] * row.rows.cwiseAbs().dot(errors));
  }
  return result;
}

InexactBlocks FactoredSide::blocks() const {
  return {.rows = basis_.order(), .first_column = first_column_, .share = kDataRounding};
}

bool FactoredSide::allows(const Change& change) const {
  return change.is_nothing() || elimination_.is_consistent(change.known, right_hand_side(change));
}

std::vector<std::vector<double>> FactoredSide::open_magnitudes() const {
  std::vector<std::vector<double>> result;
  for (const VecX& x : settled_null_vectors(elimination_, blocks())) {
    result.push_back(magnitudes_of(x));
  }
  return result;
}

std::vector<double> FactoredSide::right_hand_side(const Change& change) const {
  std::vector<Sum> sums(static_cast<std::size_t>(system_.rows));
  for (const auto& [row, value] : change.rows) {
    sums[static_cast<std::size_t>(row)].add(value);
  }
  std::vector<double> rhs;
  std::ranges::transform(sums, std::back_inserter(rhs), &Sum::rounded);
  return rhs;
}

std::vector<double> FactoredSide::magnitudes_of(const VecX& x) const {
  std::vector<double> result;
  for (std::size_t i = 0; i < units_.size(); ++i) {
    result.push_back(x[first_column_ + static_cast<int>(i)] * units_[i]);
  }
  return result;
}

}  // namespace kinestat
