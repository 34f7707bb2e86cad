// One operation of a tape, on cells that hold a number of every lane.
#pragma once

#include <cstdint>

namespace kinestat {

enum class LaneOperationKind : std::int32_t {
  add,               ///< a + b
  subtract,          ///< a - b
  multiply,          ///< a · b
  divide,            ///< a / b
  negate_product,    ///< -(a · b)
  subtract_product,  ///< a - b · c, or 0 where that is mere rounding of both
  substitute_sum,    ///< -(sum of products) / c, or 0 where the sum is mere rounding of them
  zero_within,       ///< a, or 0 where |a| ≤ b
  smaller,
  larger,
  demand_at_most,      ///< |a| ≤ b, or the lane has no answer; these write nothing
  demand_at_least,     ///< |a| ≥ b
  demand_no_underflow  ///< a = b · c, or b / c with c ≠ 0, is zero only where b or c is
};

/// Operands and target are cells. Of a substitution, a and b are its first product and their end.
struct LaneOperation {
  LaneOperationKind kind = LaneOperationKind::add;
  std::int32_t target = 0;
  std::int32_t a = 0;
  std::int32_t b = 0;
  std::int32_t c = 0;
};

struct LaneProduct {
  std::int32_t a = 0;
  std::int32_t b = 0;
};

}  // namespace kinestat
