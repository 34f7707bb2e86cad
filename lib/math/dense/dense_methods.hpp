// The ways in which dense systems are solved elsewhere, for comparison with our own.
#pragma once

#include <vector>

#include "core/types.hpp"
#include "math/numbers/double_double.hpp"

namespace kinestat {

/// float, double, long double: Gaussian elimination with partial pivoting (Eigen's PartialPivLU) in
/// numbers of 24, 53 and 64 bits; singular_values: by the singular values (Eigen's JacobiSVD).
enum class DenseMethod { float_lu, double_lu, long_double_lu, singular_values };

/// x of A x = b for a square A. What is singular gives numbers that mean nothing, or are not
/// finite.
std::vector<DoubleDouble> solve_by(DenseMethod method, const MatX& A, const VecX& b);

/// As many rows as A has columns, ascending, so independent as can be found: the pivots of a QR
/// decomposition of Aᵀ. A must have at least that many rows.
std::vector<int> independent_rows(const MatX& A);

}  // namespace kinestat
