// The basis of a space of solutions that people can read.
#pragma once

#include <span>
#include <vector>

#include "core/types.hpp"

namespace kinestat {

/// Beyond this many coefficients a list is no help.
inline constexpr std::size_t kLongestList = 20000;

/// The reduced echelon form of what the rows span, each row with a 1 at its first entry, where no
/// other row has one; entries that are rounding are exact zeros. Magnitudes are weighed in `scales`
/// (SI, one a column) where they count as zero.
/// `leading` are independent rows of the same space that have been told already: the result is then
/// what there is beside them, with zeros where they have their first entries.
MatX readable_basis(const Eigen::Ref<const MatX>& rows,
                    const VecX& scales,
                    const Eigen::Ref<const MatX>& leading = MatX());

/// Vectors as rows of a matrix with `columns` columns.
MatX rows_of(std::span<const VecX> vectors, Eigen::Index columns);

}  // namespace kinestat
