// The inverse of a small matrix whose entries are not exact.
#pragma once

#include "core/types.hpp"

namespace kinestat {

struct UncertainInverse {
  int rank = 0;
  MatX inverse;  ///< empty unless the matrix is square and of full rank
};

/// `error` is how far the entries may be off, summed: what is left of a column by less than that
/// does not count towards the rank.
UncertainInverse find_uncertain_inverse(const MatX& matrix, double error);

}  // namespace kinestat
