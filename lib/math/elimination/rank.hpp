// The rank of a matrix, and why it is believed.
#pragma once

#include <string_view>

#include "core/types.hpp"

namespace kinestat {

/// Sizes refer to the matrix after equilibration, where the largest entries are about 1.
struct RankEvidence {
  int rank = 0;
  double smallest_pivot = 0.0;   ///< of those that counted; 0 if there is none
  double largest_dropped = 0.0;  ///< the largest entry that counted as zero; 0 if none was left
  std::string_view method;       ///< "sparse elimination" or "column-pivoted QR"

  /// Decades between what counted and what did not; large means certain. Infinite (reported as
  /// null) where nothing but exact zeros was dropped.
  double gap() const;
};

/// Rank of a dense matrix by QR with column pivoting after equilibration: the second, independent
/// way beside the elimination that the passes use.
RankEvidence find_rank(const Eigen::Ref<const MatX>& matrix);

}  // namespace kinestat
