// Which values of a solution are zero for all that the numbers of its equations tell.
#pragma once

#include <span>
#include <vector>

#include "math/elimination/elimination.hpp"

namespace kinestat {

/// The numbers of a system are off: those of columns from `first_column` on, in all rows of a block
/// in which they have an entry, and the right-hand side there, by this share of their sizes.
struct InexactBlocks {
  int rows = 1;          ///< of each block
  int first_column = 0;  ///< columns before are exact
  double share = 0.0;
};

/// How far each equation may be off by that, x being its solution.
VecX row_errors(const SparseMatrix& matrix,
                std::span<const double> rhs,
                const InexactBlocks& blocks,
                const VecX& x);

/// Makes zero what the solution x has beyond zero by no more than such errors may cause:
/// |x_i| <= Σ |A⁻¹| (|δA| |x| + |δb|), row by row of the inverse.
void settle_inexact(const Elimination& factors,
                    std::span<const double> rhs,
                    const InexactBlocks& blocks,
                    VecX& x);

/// Elimination::null_vectors, set to zero likewise: a column that is zero in all of them is
/// one that the equations determine, for all that their numbers tell.
std::vector<VecX> settled_null_vectors(const Elimination& factors, const InexactBlocks& blocks);

/// Elimination::mixed_null_vector likewise.
VecX settled_null_mixture(const Elimination& factors, const InexactBlocks& blocks);

}  // namespace kinestat
