#include "math/numbers/dual_vector.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

#include "core/tolerance.hpp"

namespace kinestat {

// u = v/|v| moves by (dv - u (u dv))/|v|: zero where that is rounding of its two terms.
template <>
Vec3Of<Dual> unit_along<Dual>(const Vec3Of<Dual>& vector) {
  const Dual length = sqrt(vector.squaredNorm());
  Vec3Of<Dual> unit(vector[0] / length, vector[1] / length, vector[2] / length);
  const std::size_t count = length.derivatives.size();
  for (std::size_t p = 0; p < count; ++p) {
    const Vec3 moved =
        Vec3(derivative(vector[0], p), derivative(vector[1], p), derivative(vector[2], p)) /
        length.value;
    const double along = values_of(unit).cwiseAbs().dot(moved.cwiseAbs());
    for (Eigen::Index i = 0; i < 3; ++i) {
      std::vector<double>& slopes = unit[i].derivatives;
      const double size = std::abs(moved[i]) + std::abs(unit[i].value) * along;
      if (!slopes.empty() && std::abs(slopes[p]) <= kCancellation * size) {
        slopes[p] = 0.0;
      }
    }
  }
  return unit;
}

}  // namespace kinestat
