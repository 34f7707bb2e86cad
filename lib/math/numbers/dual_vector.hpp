// Lets Eigen hold vectors of duals.
#pragma once

#include <cmath>

#include "core/types.hpp"
#include "math/numbers/dual.hpp"
#include "math/numbers/eigen_number.hpp"

namespace kinestat {

template <>
inline constexpr bool kHasPlainArithmetic<Dual> = true;

/// The numbers of a vector without their derivatives.
template <class Scalar>
Vec3 values_of(const Vec3Of<Scalar>& vector) {
  return {value_of(vector[0]), value_of(vector[1]), value_of(vector[2])};
}

/// Along `vector`, of length 1. Unlike Eigen's, it divides by the root of a sum and so carries
/// derivatives.
template <class Scalar>
Vec3Of<Scalar> unit_along(const Vec3Of<Scalar>& vector) {
  using std::sqrt;
  const Scalar length = sqrt(vector.squaredNorm());
  return {vector[0] / length, vector[1] / length, vector[2] / length};
}

/// Of duals: the direction of a vector that a variable lengthens alone has no derivative towards
/// it, whatever rounding leaves of the difference.
template <>
Vec3Of<Dual> unit_along<Dual>(const Vec3Of<Dual>& vector);

}  // namespace kinestat

template <>
struct Eigen::NumTraits<kinestat::Dual> : kinestat::EigenNumber<kinestat::Dual, 8, 64> {};
