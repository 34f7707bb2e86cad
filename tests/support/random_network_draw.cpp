#include "support/random_network_draw.hpp"

#include <cmath>

#include <fmt/format.h>

namespace kinestat {

LayoutDraw::LayoutDraw(Layout layout, Random& random)
    : layout_(layout),
      random_(random),
      normal_(layout == Layout::planar ? Vec3(Vec3::UnitZ()) : random.direction()),
      centre_(random.chance(0.7) ? random.vector() : Vec3(Vec3::Zero())) {}

Vec3 LayoutDraw::point() {
  Vec3 result = random_.vector();
  if (layout_ == Layout::lattice) {
    for (double& coordinate : result) {
      coordinate = random_.whole(-2, 2);
    }
  }
  if (is_planar()) {
    result.z() = 0.0;
  }
  return result;
}

Vec3 LayoutDraw::point_of(const NetworkDirection& axis) {
  return layout_ == Layout::spherical ? centre_ + random_.magnitude() * axis.vector : point();
}

NetworkDirection LayoutDraw::turning() {
  switch (layout_) {
    case Layout::general:
      return random_.chance(0.3) ? along_world(0, 2) : NetworkDirection{random_.direction()};
    case Layout::lattice:
      return along_world(0, 2);
    case Layout::parallel_axes:
    case Layout::planar_in_space:
      return {(random_.chance(0.3) ? -1.0 : 1.0) * normal_};
    case Layout::spherical:
      return {random_.direction()};
    case Layout::planar:
      return random_.chance(0.5) ? along_world(2, 2)
                                 : NetworkDirection{random_.magnitude() * Vec3::UnitZ()};
  }
  return {};
}

NetworkDirection LayoutDraw::sliding() {
  switch (layout_) {
    case Layout::general:
    case Layout::lattice:
    case Layout::spherical:
      return turning();
    case Layout::parallel_axes:
      return {random_.chance(0.5) ? normal_ : perpendicular_to(normal_)};
    case Layout::planar_in_space:
      return {perpendicular_to(normal_)};
    case Layout::planar:
      return random_.chance(0.4) ? along_world(0, 1)
                                 : NetworkDirection{perpendicular_to(Vec3::UnitZ())};
  }
  return {};
}

NetworkDirection LayoutDraw::across(const NetworkDirection& other) {
  const bool is_about_z = other.vector.head<2>().isZero(0.0);
  if (is_planar()) {
    return is_about_z ? sliding() : NetworkDirection{Vec3::UnitZ().cross(other.vector)};
  }
  const bool is_along_world = !other.keyword.empty();
  if (is_along_world && (layout_ == Layout::lattice || random_.chance(0.7))) {
    NetworkDirection result = along_world(0, 2);
    while (result.keyword.back() == other.keyword.back()) {
      result = along_world(0, 2);
    }
    return result;
  }
  return {perpendicular_to(other.vector)};
}

NetworkDirection LayoutDraw::oblique_to(const NetworkDirection& other) {
  NetworkDirection result{random_.direction()};
  while (result.vector.normalized().cross(other.vector.normalized()).norm() < 0.5) {
    result.vector = random_.direction();
  }
  return result;
}

NetworkDirection LayoutDraw::along_world(int first, int last) {
  const int axis = random_.whole(first, last);
  const bool is_negative = random_.chance(0.3);
  return {.vector = (is_negative ? -1.0 : 1.0) * Vec3::Unit(axis),
          .keyword = fmt::format("{}{}", is_negative ? "-" : "", "xyz"[axis])};
}

Vec3 LayoutDraw::perpendicular_to(const Vec3& axis) {
  Vec3 result = axis.cross(random_.direction());
  while (result.norm() < 0.1) {
    result = axis.cross(random_.direction());
  }
  return result.normalized();
}

}  // namespace kinestat
