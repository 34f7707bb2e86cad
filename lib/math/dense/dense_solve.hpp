// Small dense systems of linear equations.
#pragma once

#include <optional>

#include "core/types.hpp"

namespace kinestat {

/// x of A x = b for a square A, by Gauss with complete pivoting; empty if A is singular to
/// rounding.
std::optional<VecX> solve_dense(const MatX& A, const VecX& b);

}  // namespace kinestat
