// Solutions with a matrix that has been eliminated over a field.
#pragma once

#include <span>
#include <vector>

#include "math/elimination/internal/field_elimination.hpp"

namespace kinestat {

/// sum -= row · x.
template <class Field>
void subtract_terms(const typename FieldElimination<Field>::Row& row,
                    const std::vector<typename Field::Value>& x,
                    typename Field::Value& sum) {
  Field field;
  for (const auto& cell : row) {
    const typename Field::Value& factor = at(x, cell.column);
    if (!factor.is_zero()) {
      field.subtract_product(sum, cell.value, factor);
    }
  }
}

/// The right-hand side after the steps of the elimination; empty stands for zero.
template <class Field>
std::vector<typename Field::Value> eliminated(const FieldElimination<Field>& elimination,
                                              std::span<const typename Field::Value> rhs) {
  std::vector<typename Field::Value> right(rhs.begin(), rhs.end());
  if (rhs.empty()) {
    return right;
  }
  Field field;
  for (const auto& step : elimination.steps) {
    const typename Field::Value pivot = at(right, step.pivot_row);
    if (!pivot.is_zero()) {
      field.subtract_product(at(right, step.row), step.multiplier, pivot);
    }
  }
  return right;
}

/// Fills in x at the columns of the pivots, where it must still be 0.
template <class Field>
void back_substitute(const FieldElimination<Field>& elimination,
                     std::span<const typename Field::Value> right,
                     std::vector<typename Field::Value>& x) {
  using Value = typename Field::Value;
  for (auto pivot = elimination.pivots.rbegin(); pivot != elimination.pivots.rend(); ++pivot) {
    Value sum = right.empty() ? Value() : right[static_cast<std::size_t>(pivot->row)];
    subtract_terms<Field>(at(elimination.rows, pivot->row), x, sum);
    at(x, pivot->column) = sum.is_zero() ? sum : Value(sum / pivot->value);
  }
}

/// What each row without a pivot outside `last`, which holds columns of `last` alone, leaves of the
/// right-hand side; 0 for the others.
template <class Field>
std::vector<typename Field::Value> left_by_surplus_rows(
    const FieldElimination<Field>& elimination,
    std::span<const typename Field::Value> right,
    const std::vector<typename Field::Value>& x) {
  using Value = typename Field::Value;
  std::vector<Value> left(elimination.rows.size());
  std::vector<bool> has_pivot(elimination.rows.size(), false);
  for (const auto& pivot : elimination.pivots) {
    at(has_pivot, pivot.row) = true;
  }
  for (std::size_t r = 0; r < left.size(); ++r) {
    if (!has_pivot[r]) {
      left[r] = right.empty() ? Value() : right[r];
      subtract_terms<Field>(elimination.rows[r], x, left[r]);
    }
  }
  return left;
}

}  // namespace kinestat
