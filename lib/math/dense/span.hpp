// Spans of a few vectors: what is perpendicular to them, what they have in common.
#pragma once

#include <span>
#include <vector>

#include "core/types.hpp"

namespace kinestat {

/// Columns: a basis of the x with A x = 0, by elimination with its rank decision.
MatX null_space(const Eigen::Ref<const MatX>& A);

/// Columns: a basis of what the spans of the columns of all matrices have in common. All have
/// `size` rows; without matrices it is the whole space.
MatX intersect_spans(std::span<const MatX> spans, Eigen::Index size);

/// The columns, from the left, that do not depend on those before them.
std::vector<int> independent_columns(const Eigen::Ref<const MatX>& A);

/// For each row, from the top, that does not depend on those before it, one column: where what is
/// left beside these is largest. Zeros in these columns leave no sum of the rows but zero.
std::vector<int> deciding_columns(MatX rows);

/// x of A x = b for b in the span of A, whose columns are independent.
VecX coordinates_in(const Eigen::Ref<const MatX>& A, const VecX& b);

/// Columns of the result: orthonormal, as many as the rank (kRankZero relative to the longest
/// column). Gram-Schmidt with the longest remaining column first and each projection done twice.
MatX orthonormal_range(const Eigen::Ref<const MatX>& matrix);

}  // namespace kinestat
