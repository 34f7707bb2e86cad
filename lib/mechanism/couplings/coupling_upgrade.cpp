#include "mechanism/couplings/coupling_upgrade.hpp"

#include <array>

#include "core/tolerance.hpp"
#include "mechanism/couplings/internal/catalogue_row.hpp"

namespace kinestat {

namespace {

using enum CouplingType;

// Two directions across an axis, along the world where the axis is.
std::array<Vec3, 2> across(const Vec3& axis) {
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

std::vector<CouplingUpgrade> of_revolute(const Vec3& axis, const Vec3& point) {
  const Twist slide = unit_translation(axis);
  const auto [t1, t2] = across(axis);
  const Twist turn1 = unit_rotation(t1, point);
  const Twist turn2 = unit_rotation(t2, point);
  return {{.to = cylindrical, .added = {slide}},
          {.to = universal, .added = {turn1}},
          {.to = universal, .added = {turn2}},
          {.to = spherical, .added = {turn1, turn2}},
          {.to = sphere_in_tube, .added = {turn1, turn2, slide}, .is_rare = true}};
}

std::vector<CouplingUpgrade> of_prismatic(const Vec3& axis, const Vec3& point) {
  return {{.to = cylindrical, .added = {unit_rotation(axis, point)}},
          {.to = sphere_in_tube, .added = turns_about_all(point), .is_rare = true}};
}

std::vector<CouplingUpgrade> with_turns_across(CouplingType to,
                                               const Vec3& axis,
                                               const Vec3& point) {
  const auto [t1, t2] = across(axis);
  return {{.to = to, .added = {unit_rotation(t1, point), unit_rotation(t2, point)}}};
}

std::vector<CouplingUpgrade> of_spherical() {
  std::vector<CouplingUpgrade> upgrades;
  for (int i = 0; i < 3; ++i) {
    upgrades.push_back(
        {.to = sphere_in_tube, .added = {unit_translation(Vec3(Vec3::Unit(i)))}, .is_rare = true});
  }
  return upgrades;
}

}  // namespace

std::vector<CouplingUpgrade> coupling_upgrades(CouplingType type,
                                               std::span<const Twist> freedoms,
                                               const Vec3& point) {
  switch (type) {
    case revolute:
      return of_revolute(freedoms[0].angular, point);
    case prismatic:
      return of_prismatic(freedoms[0].linear, point);
    case cylindrical:
      return with_turns_across(sphere_in_tube, freedoms[0].angular, point);
    case universal: {
      const Vec3 third = freedoms[0].angular.cross(freedoms[1].angular).normalized();
      return {{.to = spherical, .added = {unit_rotation(third, point)}}};
    }
    case spherical:
      return of_spherical();
    case planar:
      return with_turns_across(point_contact, freedoms[0].angular, point);
    case line_contact:
      return {{.to = point_contact, .added = {unit_rotation(freedoms[3].linear, point)}}};
    case helical:
    case point_contact:
    case cam:
    case sphere_in_tube:
    case pin_in_slot:
    case rigid:
    case gear:
    case bevel_gear:
    case worm:
    case rack:
    case clutch:
    case brake:
    case cable:
    case screws:
      return {};
  }
  return {};
}

}  // namespace kinestat
