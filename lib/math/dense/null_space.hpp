// The null space of a wide matrix by its singular values.
#pragma once

#include "core/types.hpp"

namespace kinestat {

/// A matrix with at most as many rows as columns, taken apart by its singular values.
struct NullSpace {
  MatX basis;            ///< orthonormal columns: columns minus rows of them, whatever the rank
  VecX singular_values;  ///< falling, one a row

  /// Columns x rows: an error e of the rows moves the null space by about inverse * e. Infinite
  /// where the rows depend on each other exactly.
  MatX inverse;

  /// The smallest by the largest singular value; 0 if the rows depend on each other.
  double reciprocal_condition() const;
};

NullSpace find_null_space(const Eigen::Ref<const MatX>& matrix);

}  // namespace kinestat
