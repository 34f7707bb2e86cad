// What the conditions of five positions leave open, with a hundred digits.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "math/numbers/big_float.hpp"

namespace kinestat {

/// One condition, or one vector of the null space: (u, v, a, b, p, q, h), see ConditionRowsOf.
using PreciseRow = std::array<BigFloat, 7>;

struct PreciseBasis {
  std::array<PreciseRow, 3> vectors;  ///< orthonormal
  double reciprocal_condition =
      0.0;  ///< the last pivot of a complete elimination of rows of size 1
};

/// The null space of four rows, each with largest entry 1. Empty if they depend on each other to
/// the last digit.
std::optional<PreciseBasis> find_precise_null_space(std::vector<PreciseRow> rows);

}  // namespace kinestat
