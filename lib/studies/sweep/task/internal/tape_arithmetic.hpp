// What is often noted on a tape.
#pragma once

#include "math/tapes/lane_recorder.hpp"

namespace kinestat {

inline TapeNumber size_on_tape(TapeNumber number, LaneRecorder& recorder) {
  return recorder.larger(number, recorder.negate_product(number, recorder.constant(1.0)));
}

/// Zero where that is mere rounding of both.
inline TapeNumber settled_difference(TapeNumber a, TapeNumber b, LaneRecorder& recorder) {
  return recorder.subtract_product(a, b, recorder.constant(1.0));
}

}  // namespace kinestat
