// The smallest solution of equations that leave some of it open.
#pragma once

#include "core/types.hpp"

namespace kinestat {

/// Of all x that make |A x - b| least, that of least norm.
VecX least_norm_solution(const MatX& A, const VecX& b);

}  // namespace kinestat
