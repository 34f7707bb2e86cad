#include "math/elimination/data_zero.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/numbers/settled.hpp"

namespace kinestat {

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
  const VecX errors = row_errors(factors.matrix(), rhs, blocks, x);
  // Few values are so small that their own row of the inverse has to say.
  const VecX most = factors.most_change(errors);
  const std::vector<int>& open = factors.free_columns();
  VecX settled_x = x;
  for (Eigen::Index c = 0; c < x.size(); ++c) {
    const bool is_open = std::ranges::binary_search(open, static_cast<int>(c));
    if (x[c] == 0.0 || is_open || std::abs(x[c]) > most[c]) {
      continue;
    }
    const AdjointSolution row = factors.solve_adjoint(VecX::Unit(x.size(), c));
    settled_x[c] = settled(x[c], row.rows.cwiseAbs().dot(errors));
  }
  x = std::move(settled_x);
}

}  // namespace kinestat
