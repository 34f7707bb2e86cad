// Singular values of a small dense matrix.
#pragma once

#include "core/types.hpp"

namespace kinestat {

/// By Jacobi's method, exact to rounding of the largest; 0 without columns, or with more than rows.
double smallest_singular_value(const Eigen::Ref<const MatX>& matrix);

/// The k-th largest (k from 1) as a share of the largest; 0 beyond the last, and of a zero matrix.
double singular_value_share(const Eigen::Ref<const MatX>& matrix, int k);

}  // namespace kinestat
