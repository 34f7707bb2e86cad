// The reduced row echelon form of a dense matrix, for display.
#pragma once

#include <vector>

#include "core/types.hpp"

namespace kinestat {

/// Zero rows at the bottom are kept, so that redundant equations stay visible.
struct Echelon {
  MatX matrix;                     ///< reduced: pivots are 1, alone in their columns
  std::vector<int> pivot_columns;  ///< ascending; their number is the rank
};

/// Gauss-Jordan with the largest entry of each column as pivot. The source divides by coordinates
/// that may be zero (b_y, d_y in Cazangi 2008, eqs. 3.63 and 3.87); this does not.
Echelon find_echelon(const Eigen::Ref<const MatX>& matrix);

}  // namespace kinestat
