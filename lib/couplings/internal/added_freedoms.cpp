#include "couplings/internal/added_freedoms.hpp"

#include "core/tolerance.hpp"
#include "couplings/internal/catalogue_row.hpp"

namespace kinestat {

std::array<Vec3, 2> readable_across(const Vec3& axis) {
  for (int i = 0; i < 3; ++i) {
    if (Vec3::Unit(i).cross(axis).norm() <= kParallelAxes) {
      return {Vec3::Unit(i == 0 ? 1 : 0), Vec3::Unit(i == 2 ? 1 : 2)};
    }
  }
  const auto [first, second] = transverse_to<double>(axis);
  return {first, second};
}

std::vector<Twist> turns_about_all(const Vec3& point) {
  return {unit_rotation(Vec3::UnitX(), point),
          unit_rotation(Vec3::UnitY(), point),
          unit_rotation(Vec3::UnitZ(), point)};
}

std::vector<CouplingUpgrade> with_turns_across(CouplingType to,
                                               const Vec3& axis,
                                               const Vec3& point) {
  const auto [t1, t2] = readable_across(axis);
  return {{.to = to, .added = {unit_rotation(t1, point), unit_rotation(t2, point)}}};
}

}  // namespace kinestat
