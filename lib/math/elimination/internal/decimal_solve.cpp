#include "math/elimination/internal/decimal_solve.hpp"

#include <cmath>
#include <utility>

#include "math/elimination/internal/field_solve.hpp"
#include "math/numbers/internal/unit_roundoff.hpp"

namespace kinestat {

namespace {

using Decimals = FieldElimination<DecimalField>;

// A sum with the sizes of all that went into it.
struct DecimalSum {
  BigFloat value;
  BigFloat size;

  void subtract_product(const BigFloat& a, const BigFloat& b) {
    const BigFloat term = a * b;
    value -= term;
    size += abs(term);
  }

  // How far a value that counts as zero may be from it.
  BigFloat settle() {
    if (!DecimalField::is_zero_among(value, size)) {
      return 0;
    }
    value = 0;
    return DecimalField::rounding() * size;
  }
};

// The right-hand side after the steps of the elimination. A difference of two is zero by its own
// terms; what a row has inherited counts when it is told whether a surplus row holds.
std::vector<DecimalSum> eliminated_sums(const Decimals& decimals,
                                        const std::vector<BigFloat>& rhs) {
  std::vector<DecimalSum> right;
  right.reserve(rhs.size());
  for (const BigFloat& one : rhs) {
    right.push_back({.value = one, .size = BigFloat(abs(one))});
  }
  for (const Decimals::Step& step : decimals.steps) {
    const DecimalSum& pivot = at(right, step.pivot_row);
    DecimalSum& row = at(right, step.row);
    DecimalSum difference{.value = row.value, .size = BigFloat(abs(row.value))};
    difference.subtract_product(step.multiplier, pivot.value);
    difference.settle();
    row.value = difference.value;
    row.size += abs(step.multiplier) * pivot.size;
  }
  return right;
}

// Gives back how far each x that counts as zero may be from it.
std::vector<BigFloat> back_substitute_sums(const Decimals& decimals,
                                           const std::vector<DecimalSum>& right,
                                           std::vector<BigFloat>& x) {
  std::vector<BigFloat> around_zero(x.size());
  for (auto pivot = decimals.pivots.rbegin(); pivot != decimals.pivots.rend(); ++pivot) {
    const BigFloat& start = at(right, pivot->row).value;
    DecimalSum sum{.value = start, .size = BigFloat(abs(start))};
    for (const Decimals::Cell& cell : at(decimals.rows, pivot->row)) {
      if (cell.column != pivot->column) {
        sum.subtract_product(cell.value, at(x, cell.column));
      }
    }
    at(around_zero, pivot->column) = sum.settle() / abs(pivot->value);
    at(x, pivot->column) = sum.value / pivot->value;
  }
  return around_zero;
}

bool surplus_rows_hold(const Decimals& decimals,
                       const std::vector<DecimalSum>& right,
                       const std::vector<BigFloat>& x) {
  std::vector<bool> has_pivot(right.size(), false);
  for (const Decimals::Pivot& pivot : decimals.pivots) {
    at(has_pivot, pivot.row) = true;
  }
  for (std::size_t r = 0; r < right.size(); ++r) {
    DecimalSum left = right[r];
    for (const Decimals::Cell& cell : decimals.rows[r]) {
      if (!has_pivot[r]) {
        left.subtract_product(cell.value, at(x, cell.column));
      }
    }
    if (!has_pivot[r] && !DecimalField::is_zero_among(left.value, left.size)) {
      return false;
    }
  }
  return true;
}

// b - A x of the scaled rows.
std::vector<BigFloat> residual(const DecimalFactors& factors,
                               const std::vector<BigFloat>& rhs,
                               const std::vector<BigFloat>& x) {
  std::vector<BigFloat> rest = rhs;
  for (const DecimalEntry& entry : factors.entries) {
    at(rest, entry.row) -= entry.value * at(x, entry.column);
  }
  return rest;
}

}  // namespace

ExactInputSolution solve_decimals(const DecimalFactors& factors,
                                  std::vector<BigFloat> x,
                                  const std::vector<BigFloat>& rhs) {
  const std::vector<DecimalSum> right = eliminated_sums(factors.decimals, rhs);
  const std::vector<BigFloat> around_zero = back_substitute_sums(factors.decimals, right, x);
  std::vector<BigFloat> correction(x.size());
  back_substitute<DecimalField>(
      factors.decimals,
      eliminated<DecimalField>(factors.decimals, residual(factors, rhs, x)),
      correction);
  const auto columns = static_cast<Eigen::Index>(x.size());
  ExactInputSolution result{.x = VecX(columns), .bound = VecX(columns)};
  for (int c = 0; c < static_cast<int>(columns); ++c) {
    const double unit = at(factors.scaling.columns, c);
    const BigFloat next = 2 * abs(at(correction, c)) + at(around_zero, c);
    result.x[c] = unit * static_cast<double>(at(x, c));
    result.bound[c] = kUnitRoundoff * std::abs(result.x[c]) + unit * static_cast<double>(next);
  }
  result.consistent = surplus_rows_hold(factors.decimals, right, x);
  return result;
}

}  // namespace kinestat
