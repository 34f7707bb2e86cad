// The principal values of a symmetric tensor.
#pragma once

#include "core/types.hpp"

namespace kinestat {

/// Ascending. Only the lower half of the tensor is read.
Vec3 principal_values(const Eigen::Matrix3d& tensor);

}  // namespace kinestat
