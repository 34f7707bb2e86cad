#include "math/elimination/data_zero.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/numbers/settled.hpp"

namespace kinestat {

namespace {

// A solution, how far each equation may be off by its numbers, and the most that may change.
struct InexactSolution {
  VecX& x;
  VecX errors;
  VecX most;
};

// Few values are so small that their own row of the inverse has to say; it serves all solutions.
void settle_column(const Elimination& factors, int column, std::vector<InexactSolution>& all) {
  const auto is_in_doubt = [&](const InexactSolution& one) {
    return one.x[column] != 0.0 && std::abs(one.x[column]) <= one.most[column];
  };
  if (std::ranges::none_of(all, is_in_doubt)) {
    return;
  }
  const VecX row =
      factors.solve_adjoint(VecX::Unit(factors.matrix().columns, column)).rows.cwiseAbs();
  for (InexactSolution& one : all) {
    if (is_in_doubt(one)) {
      one.x[column] = settled(one.x[column], row.dot(one.errors));
    }
  }
}

void settle_all(const Elimination& factors,
                std::span<const double> rhs,
                const InexactBlocks& blocks,
                std::span<VecX> solutions) {
  std::vector<InexactSolution> all;
  all.reserve(solutions.size());
  for (VecX& x : solutions) {
    VecX errors = row_errors(factors.matrix(), rhs, blocks, x);
    VecX most = factors.most_change(errors);
    all.push_back({.x = x, .errors = std::move(errors), .most = std::move(most)});
  }
  const std::vector<int>& open = factors.free_columns();
  for (int column = 0; column < factors.matrix().columns; ++column) {
    if (!std::ranges::binary_search(open, column)) {
      settle_column(factors, column, all);
    }
  }
}

}  // namespace

VecX row_errors(const SparseMatrix& matrix,
                std::span<const double> rhs,
                const InexactBlocks& blocks,
                const VecX& x) {
  VecX of_blocks = VecX::Zero(matrix.rows / blocks.rows + 1);
  for (const SparseEntry& entry : matrix.entries) {
    if (entry.column >= blocks.first_column) {
      of_blocks[entry.row / blocks.rows] += std::abs(entry.value * x[entry.column]);
    }
  }
  for (std::size_t r = 0; r < rhs.size(); ++r) {
    of_blocks[static_cast<int>(r) / blocks.rows] += std::abs(rhs[r]);
  }
  VecX errors(matrix.rows);
  for (int r = 0; r < matrix.rows; ++r) {
    errors[r] = blocks.share * of_blocks[r / blocks.rows];
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
