#include "math/bounded_vector.hpp"

namespace kinestat {

namespace {

template <class Component>
BoundedVector by_component(const Component& component) {
  BoundedVector result;
  for (int i = 0; i < 3; ++i) {
    const BoundedNumber one = component(i);
    result.value[i] = one.value;
    result.bound[i] = one.bound;
  }
  return result;
}

}  // namespace

Vec3 BoundedVector::zeroed() const {
  return (value.array().abs() <= bound.array() && bound.array().isFinite())
      .select(Vec3::Zero(), value);
}

BoundedVector rounded_vector(const Vec3& value, double share) {
  return {.value = value, .bound = Vec3::Constant(share * value.cwiseAbs().maxCoeff())};
}

BoundedVector operator+(const BoundedVector& a, const BoundedVector& b) {
  return by_component([&](int i) { return a.component(i) + b.component(i); });
}

BoundedVector operator-(const BoundedVector& a, const BoundedVector& b) {
  return by_component([&](int i) { return a.component(i) - b.component(i); });
}

BoundedVector operator*(const BoundedNumber& factor, const BoundedVector& a) {
  return by_component([&](int i) { return factor * a.component(i); });
}

BoundedVector cross(const BoundedVector& a, const BoundedVector& b) {
  return by_component([&](int i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    return a.component(j) * b.component(k) - a.component(k) * b.component(j);
  });
}

BoundedNumber dot(const BoundedVector& a, const BoundedVector& b) {
  BoundedNumber sum;
  for (int i = 0; i < 3; ++i) {
    sum = sum + a.component(i) * b.component(i);
  }
  return sum;
}

}  // namespace kinestat
