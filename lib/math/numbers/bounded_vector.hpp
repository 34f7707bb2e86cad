// Vectors with how far each component may be off.
#pragma once

#include "core/types.hpp"
#include "math/numbers/bounded_number.hpp"

namespace kinestat {

/// Each component of the true vector lies within that of `bound` of that of `value`.
struct BoundedVector {
  Vec3 value = Vec3::Zero();
  Vec3 bound = Vec3::Zero();  ///< never negative

  BoundedNumber component(int i) const { return {.value = value[i], .bound = bound[i]}; }

  /// The components that their bounds tell from zero; the others are zero.
  Vec3 zeroed() const;
};

/// A vector each of whose components may be off by that share of the largest one.
BoundedVector rounded_vector(const Vec3& value, double share);

BoundedVector operator+(const BoundedVector& a, const BoundedVector& b);
BoundedVector operator-(const BoundedVector& a, const BoundedVector& b);
BoundedVector operator*(const BoundedNumber& factor, const BoundedVector& a);
BoundedVector cross(const BoundedVector& a, const BoundedVector& b);
BoundedNumber dot(const BoundedVector& a, const BoundedVector& b);

}  // namespace kinestat
