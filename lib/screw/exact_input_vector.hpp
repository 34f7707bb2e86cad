// Lets Eigen, the screws and the binders hold numbers as typed.
#pragma once

#include <cmath>

#include "core/tolerance.hpp"
#include "math/numbers/eigen_number.hpp"
#include "math/numbers/exact_input.hpp"
#include "screw/twist.hpp"

namespace kinestat {

template <>
inline constexpr bool kHasPlainArithmetic<ExactInput> = true;

}  // namespace kinestat

template <>
struct Eigen::NumTraits<kinestat::ExactInput>
    : kinestat::EigenNumber<kinestat::ExactInput, 64, 512> {};

namespace kinestat {

/// What is rounding of doubles may be more than nothing in the numbers as typed: only their double,
/// which takes the decisions, becomes zero.
template <>
inline Vec3Of<ExactInput> moment_of_line<ExactInput>(const Vec3In<ExactInput>& point,
                                                     const Vec3In<ExactInput>& direction) {
  Vec3Of<ExactInput> moment;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    const ExactInput plus = point[j] * direction[k];
    const ExactInput minus = point[k] * direction[j];
    moment[i] = plus - minus;
    const double size = std::abs(plus.value) + std::abs(minus.value);
    if (std::abs(moment[i].value) <= kCancellation * size) {
      moment[i].value = 0.0;
    }
  }
  return moment;
}

}  // namespace kinestat
