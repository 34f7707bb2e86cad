// The smallest singular value of a small dense matrix.
#pragma once

#include "core/types.hpp"

namespace kinestat {

/// By Jacobi's method, exact to rounding of the largest; 0 without columns, or with more than rows.
double smallest_singular_value(const Eigen::Ref<const MatX>& matrix);

}  // namespace kinestat
