#include "mechanism/coupling_catalogue.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/contract.hpp"

namespace kinestat {

namespace {

constexpr std::array<char, 3> kLetters = {'x', 'y', 'z'};

Vec3 world_axis(int i) {
  return Vec3::Unit(i);
}

std::string name_along(char kind, const Axis& axis) {
  return axis.keyword == 0 ? std::string(1, kind) : std::string{kind, axis.keyword};
}

NamedTwist rotation(const CouplingGeometry& g) {
  return {.name = name_along('w', g.axis),
          .is_rotation = true,
          .screw = unit_rotation(g.axis.direction, g.at)};
}

NamedTwist translation(const CouplingGeometry& g) {
  return {.name = name_along('v', g.axis),
          .is_rotation = false,
          .screw = unit_translation(g.axis.direction)};
}

NamedWrench force(std::string name, const Vec3& direction, const Vec3& at) {
  return {.name = std::move(name), .is_couple = false, .screw = unit_force(direction, at)};
}

NamedWrench couple(std::string name, const Vec3& direction) {
  return {.name = std::move(name), .is_couple = true, .screw = unit_couple(direction)};
}

struct Transverse {
  Vec3 first;
  Vec3 second;
};

// t1 = normalised(k - (k·a)a) with the first k of least |k·a|, t2 = a x t1.
Transverse transverse_to(const Vec3& a) {
  int k = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(a[i]) < std::abs(a[k])) {
      k = i;
    }
  }
  const Vec3 first = (world_axis(k) - a[k] * a).normalized();
  return {.first = first, .second = a.cross(first)};
}

void add_forces(const Vec3& at, Space space, std::vector<NamedWrench>& constraints) {
  const int count = space == Space::planar ? 2 : 3;
  for (int i = 0; i < count; ++i) {
    constraints.push_back(
        force(std::string{'R', kLetters[static_cast<std::size_t>(i)]}, world_axis(i), at));
  }
}

void add_couples(Space space, std::vector<NamedWrench>& constraints) {
  for (int i = space == Space::planar ? 2 : 0; i < 3; ++i) {
    constraints.push_back(
        couple(std::string{'T', kLetters[static_cast<std::size_t>(i)]}, world_axis(i)));
  }
}

void add_couples_across(const Axis& axis, std::vector<NamedWrench>& constraints) {
  if (axis.keyword == 0) {
    const Transverse t = transverse_to(axis.direction);
    constraints.push_back(couple("T1", t.first));
    constraints.push_back(couple("T2", t.second));
    return;
  }
  for (int i = 0; i < 3; ++i) {
    const char letter = kLetters[static_cast<std::size_t>(i)];
    if (letter != axis.keyword) {
      constraints.push_back(couple(std::string{'T', letter}, world_axis(i)));
    }
  }
}

void add_forces_across(const CouplingGeometry& g,
                       Space space,
                       std::vector<NamedWrench>& constraints) {
  if (g.axis.keyword != 0) {
    for (int i = 0; i < (space == Space::planar ? 2 : 3); ++i) {
      const char letter = kLetters[static_cast<std::size_t>(i)];
      if (letter != g.axis.keyword) {
        constraints.push_back(force(std::string{'R', letter}, world_axis(i), g.at));
      }
    }
  } else if (space == Space::planar) {
    constraints.push_back(force("R", Vec3::UnitZ().cross(g.axis.direction), g.at));
  } else {
    const Transverse t = transverse_to(g.axis.direction);
    constraints.push_back(force("R1", t.first, g.at));
    constraints.push_back(force("R2", t.second, g.at));
  }
}

CouplingScrews revolute(const CouplingGeometry& g, Space space) {
  CouplingScrews screws{.freedoms = {rotation(g)}, .constraints = {}};
  add_forces(g.at, space, screws.constraints);
  if (space == Space::spatial) {
    add_couples_across(g.axis, screws.constraints);
  }
  return screws;
}

CouplingScrews prismatic(const CouplingGeometry& g, Space space) {
  CouplingScrews screws{.freedoms = {translation(g)}, .constraints = {}};
  add_forces_across(g, space, screws.constraints);
  add_couples(space, screws.constraints);
  return screws;
}

CouplingScrews rigid(const CouplingGeometry& g, Space space) {
  CouplingScrews screws;
  add_forces(g.at, space, screws.constraints);
  add_couples(space, screws.constraints);
  return screws;
}

}  // namespace

bool is_in_catalogue(CouplingType type) {
  constexpr std::array kRows = {CouplingType::revolute,
                                CouplingType::prismatic,
                                CouplingType::gear,
                                CouplingType::clutch,
                                CouplingType::brake,
                                CouplingType::rigid};
  return std::ranges::find(kRows, type) != kRows.end();
}

CouplingScrews coupling_screws(CouplingType type, Space space, const CouplingGeometry& geometry) {
  switch (type) {
    case CouplingType::revolute:
      return revolute(geometry, space);
    case CouplingType::prismatic:
      return prismatic(geometry, space);
    case CouplingType::gear:
      return {.freedoms = {rotation(geometry)},
              .constraints = {force("Rc", geometry.line_of_action, geometry.at)}};
    case CouplingType::clutch:
    case CouplingType::brake:
      return {.freedoms = {rotation(geometry)}, .constraints = {}};
    case CouplingType::rigid:
      return rigid(geometry, space);
    case CouplingType::helical:
    case CouplingType::cylindrical:
    case CouplingType::universal:
    case CouplingType::spherical:
    case CouplingType::planar:
    case CouplingType::point_contact:
    case CouplingType::cam:
    case CouplingType::line_contact:
    case CouplingType::sphere_in_tube:
    case CouplingType::pin_in_slot:
    case CouplingType::bevel_gear:
    case CouplingType::worm:
    case CouplingType::rack:
    case CouplingType::cable:
    case CouplingType::screws:
      break;
  }
  KINESTAT_EXPECTS(is_in_catalogue(type));
  return {};
}

NamedWrench internal_action(const NamedTwist& freedom, const Vec3& at) {
  if (freedom.is_rotation) {
    return couple(freedom.name, freedom.screw.angular);
  }
  return force(freedom.name, freedom.screw.linear, at);
}

}  // namespace kinestat
