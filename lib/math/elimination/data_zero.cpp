#include "math/elimination/data_zero.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "math/numbers/zero_within_bound.hpp"

namespace kinestat {

namespace {

// Columns with a value that is not surely beyond `most`, the change that the largest values of all
// solutions may cause, or is a NaN. They are few, and their own row of the inverse has to say.
std::vector<int> doubtful_columns(const Elimination& factors,
                                  std::span<const VecX> solutions,
                                  const VecX& most) {
  const std::vector<int>& open = factors.free_columns();
  std::vector<int> columns;
  for (int column = 0; column < factors.matrix().columns; ++column) {
    const bool is_in_doubt = std::ranges::any_of(solutions, [&](const VecX& x) {
      return x[column] != 0.0 && !(std::abs(x[column]) > most[column]);
    });
    if (is_in_doubt && !std::ranges::binary_search(open, column)) {
      columns.push_back(column);
    }
  }
  return columns;
}

// The row of the inverse serves all solutions.
void settle_column(const Elimination& factors,
                   int column,
                   std::span<const VecX> errors,
                   std::span<const VecX> most,
                   std::span<VecX> solutions) {
  VecX row;
  for (std::size_t i = 0; i < solutions.size(); ++i) {
    double& value = solutions[i][column];
    if (value == 0.0 || !(std::abs(value) <= most[i][column])) {
      continue;
    }
    if (row.size() == 0) {
      row = factors.solve_adjoint(VecX::Unit(factors.matrix().columns, column)).rows.cwiseAbs();
    }
    value = zero_within_bound(value, row.dot(errors[i]));
  }
}

void settle_all(const Elimination& factors,
                std::span<const double> rhs,
                const InexactBlocks& blocks,
                std::span<VecX> solutions) {
  if (solutions.empty()) {
    return;
  }
  // One bound for all of them, with which those of each are not worked out where none is in doubt.
  VecX largest = solutions.front().cwiseAbs();
  for (const VecX& x : solutions.subspan(1)) {
    largest = largest.cwiseMax(x.cwiseAbs());
  }
  std::vector<VecX> most = {
      factors.most_change(row_errors(factors.matrix(), rhs, blocks, largest))};
  const std::vector<int> columns = doubtful_columns(factors, solutions, most.front());
  if (columns.empty()) {
    return;
  }
  std::vector<VecX> errors;
  errors.reserve(solutions.size());
  for (const VecX& x : solutions) {
    errors.push_back(row_errors(factors.matrix(), rhs, blocks, x));
  }
  if (solutions.size() > 1) {
    most.clear();
    for (const VecX& one : errors) {
      most.push_back(factors.most_change(one));
    }
  }
  for (const int column : columns) {
    settle_column(factors, column, errors, most, solutions);
  }
}

}  // namespace

VecX row_errors(const SparseMatrix& matrix,
                std::span<const double> rhs,
                const InexactBlocks& blocks,
                const VecX& x) {
  VecX errors = VecX::Zero(matrix.rows);
  for (const SparseEntry& entry : matrix.entries) {
    if (entry.column >= blocks.first_column) {
      errors[entry.row] += std::abs(entry.value * x[entry.column]);
    }
  }
  for (std::size_t r = 0; r < rhs.size(); ++r) {
    errors[static_cast<int>(r)] += std::abs(rhs[r]);
  }
  for (int first = 0; first < matrix.rows; first += blocks.rows) {
    auto block = errors.segment(first, std::min(blocks.rows, matrix.rows - first));
    block.setConstant(blocks.share * block.sum());
  }
  return errors;
}

void settle_inexact(const Elimination& factors,
                    std::span<const double> rhs,
                    const InexactBlocks& blocks,
                    VecX& x) {
  settle_all(factors, rhs, blocks, std::span(&x, 1));
}

std::vector<VecX> settled_null_vectors(const Elimination& factors, const InexactBlocks& blocks) {
  std::vector<VecX> vectors = factors.null_vectors();
  settle_all(factors, {}, blocks, vectors);
  return vectors;
}

VecX settled_null_mixture(const Elimination& factors, const InexactBlocks& blocks) {
  VecX mixture = factors.mixed_null_vector();
  settle_inexact(factors, {}, blocks, mixture);
  return mixture;
}

}  // namespace kinestat
