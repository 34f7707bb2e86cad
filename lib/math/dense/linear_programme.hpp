// The least value of a linear function of numbers that are not negative.
#pragma once

#include <optional>

#include "core/types.hpp"

namespace kinestat {

/// The x >= 0 with A x = b that makes costs · x least, by the simplex method on a dense tableau
/// (Dantzig 1963); by Bland's rule (1977) after a step that gains nothing, so that it cannot go
/// round in circles. For a few dozen unknowns. No cost is negative, so that there is a least value
/// wherever there is a solution. At most as many x as A has rows are not zero. Entries of A should
/// be of similar size; what is smaller than kRankZero beside the largest counts as zero. Empty if
/// there is no solution, or rounding keeps the search from one.
std::optional<VecX> find_least_cost(const MatX& A, const VecX& b, const VecX& costs);

}  // namespace kinestat
