#include "math/numbers/bounded_vector.hpp"

#include "math/numbers/bounded_arithmetic.hpp"

namespace kinestat {

Vec3 BoundedVector::zeroed() const {
  return (value.array().abs() <= bound.array() && bound.array().isFinite())
      .select(Vec3::Zero(), value);
}

BoundedVector rounded_vector(const Vec3& value, double share) {
  return {.value = value, .bound = Vec3::Constant(share * value.cwiseAbs().maxCoeff())};
}

BoundedVector operator+(const BoundedVector& a, const BoundedVector& b) {
  return bounded_sum(a, b);
}

BoundedVector operator-(const BoundedVector& a, const BoundedVector& b) {
  return bounded_difference(a, b);
}

BoundedVector operator*(const BoundedNumber& factor, const BoundedVector& a) {
  return bounded_product(factor, a);
}

BoundedVector cross(const BoundedVector& a, const BoundedVector& b) {
  return bounded_by_component([&](int i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    return bounded_difference(bounded_product(a.component(j), b.component(k)),
                              bounded_product(a.component(k), b.component(j)));
  });
}

BoundedNumber dot(const BoundedVector& a, const BoundedVector& b) {
  return bounded_dot(a, b);
}

}  // namespace kinestat
