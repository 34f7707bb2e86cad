// An orthonormal basis of what the columns of a matrix span.
#pragma once

#include "core/types.hpp"

namespace kinestat {

/// Columns of the result: orthonormal, as many as the rank (kRankZero relative to the longest
/// column). Gram-Schmidt with the longest remaining column first and each projection done twice.
MatX orthonormal_range(const Eigen::Ref<const MatX>& matrix);

}  // namespace kinestat
