#include "support/random_network_catalogue.hpp"

#include <algorithm>
#include <utility>

#include "support/random_network_screws.hpp"

namespace kinestat {

namespace {

using enum CouplingType;
using Keys = std::vector<NetworkKey>;

NetworkKey at(const Vec3& point) {
  return {.word = "at", .value = NetworkPoint{point}};
}

// In the plane an axis of turning is z unless the file says otherwise.
void add_axis(const NetworkDirection& axis, LayoutDraw& draw, Keys& keys) {
  if (!draw.is_planar() || draw.random().chance(0.4)) {
    keys.push_back({.word = "axis", .value = axis});
  }
}

Keys about_axis(LayoutDraw& draw) {
  const NetworkDirection axis = draw.turning();
  Keys keys = {at(draw.point_of(axis))};
  add_axis(axis, draw, keys);
  return keys;
}

// A direction, with a point that some types may lack.
Keys along(std::string word, const NetworkDirection& direction, double place, LayoutDraw& draw) {
  Keys keys = {{.word = std::move(word), .value = direction}};
  if (draw.random().chance(place)) {
    keys.push_back(at(draw.point_of(direction)));
  }
  return keys;
}

Keys helical_keys(LayoutDraw& draw) {
  Keys keys = about_axis(draw);
  const bool is_lead = draw.random().chance(0.5);
  keys.push_back({.word = is_lead ? "lead" : "pitch",
                  .value = NetworkLength{(is_lead ? 3.0 : 0.5) * draw.random().magnitude()}});
  return keys;
}

Keys universal_keys(LayoutDraw& draw) {
  const NetworkDirection first = draw.turning();
  const bool is_square = draw.layout() != Layout::general || draw.random().chance(0.7);
  const NetworkDirection second = is_square ? draw.across(first) : draw.oblique_to(first);
  const Vec3 point = draw.layout() == Layout::spherical ? draw.centre() : draw.point();
  return {at(point), {.word = "axes", .value = std::vector{first, second}}};
}

Keys line_contact_keys(LayoutDraw& draw) {
  Keys keys = along("normal", draw.sliding(), 1.0, draw);
  const NetworkDirection normal = std::get<NetworkDirection>(keys.front().value);
  keys.push_back({.word = "line", .value = draw.across(normal)});
  return keys;
}

// By its line of action, or by its tangent and angles.
Keys gear_keys(Completeness completeness, LayoutDraw& draw) {
  Random& random = draw.random();
  const NetworkDirection axis = draw.turning();
  Keys keys = {at(draw.point_of(axis))};
  add_axis(axis, draw, keys);
  if (random.chance(0.5)) {
    keys.push_back({.word = "line_of_action", .value = draw.across(axis)});
  } else {
    keys.push_back({.word = "tangent", .value = draw.across(axis)});
    keys.push_back({.word = "pressure_angle", .value = NetworkAngle{random.between(-0.2, 0.6)}});
    if (!draw.is_planar() && random.chance(0.5)) {
      keys.push_back({.word = "helix_angle", .value = NetworkAngle{random.between(-0.6, 0.6)}});
    }
  }
  if (completeness == Completeness::complementary || random.chance(0.3)) {
    keys.push_back({.word = "contact", .value = true});
  }
  return keys;
}

// The line of action is perpendicular to the velocity of the relative motion at the pitch point.
void add_relative_motion(const NetworkScrew& screw, LayoutDraw& draw, Keys& keys) {
  const Vec3 pitch_point = std::get<NetworkPoint>(keys.front().value).at;
  const Vec3 direction = screw.direction.vector.normalized();
  const Vec3 velocity =
      screw.has_line() ? Vec3(direction.cross(pitch_point - screw.at) + screw.pitch * direction)
                       : direction;
  const NetworkDirection sliding{velocity, screw.has_line() ? "" : screw.direction.keyword};
  keys.push_back({.word = "screw", .value = screw});
  keys.push_back({.word = "line_of_action", .value = draw.across(sliding)});
}

// Rolling about the common tangent of the cones, given as an axis or as a screw through the apex.
Keys bevel_gear_keys(LayoutDraw& draw) {
  const NetworkDirection axis = draw.turning();
  const Vec3 pitch_point = draw.point_of(axis);
  Keys keys = {at(pitch_point)};
  if (draw.random().chance(0.5)) {
    const Vec3 apex = pitch_point + draw.random().magnitude() * axis.vector;
    keys.push_back({.word = "screw", .value = NetworkScrew{ScrewWord::rotation, axis, apex, 0.0}});
  } else {
    keys.push_back({.word = "axis", .value = axis});
  }
  keys.push_back({.word = "line_of_action", .value = draw.turning()});
  return keys;
}

Keys worm_keys(LayoutDraw& draw) {
  const NetworkDirection axis = draw.turning();
  const Vec3 foot = draw.point_of(axis);
  const Vec3 offset = draw.random().magnitude() * draw.across(axis).vector.normalized();
  Keys keys = {at(foot + offset)};
  const double pitch = 0.5 * draw.random().magnitude();
  add_relative_motion({ScrewWord::rotation, axis, foot, pitch}, draw, keys);
  return keys;
}

// Rolling at the pitch point, or sliding of two racks.
Keys rack_keys(LayoutDraw& draw) {
  const NetworkDirection axis = draw.turning();
  Keys keys = {at(draw.point_of(axis))};
  if (draw.random().chance(0.5)) {
    add_axis(axis, draw, keys);
    keys.push_back({.word = "line_of_action", .value = draw.across(axis)});
  } else {
    add_relative_motion({.kind = ScrewWord::translation, .direction = draw.sliding()}, draw, keys);
  }
  return keys;
}

Keys cable_keys(LayoutDraw& draw) {
  const Vec3 from = draw.point();
  Vec3 to = draw.point();
  while ((to - from).norm() < 0.3) {
    to = draw.point();
  }
  return {{.word = "from", .value = NetworkPoint{from}}, {.word = "to", .value = NetworkPoint{to}}};
}

}  // namespace

std::vector<CouplingType> types_of(Space space, Completeness completeness) {
  std::vector<CouplingType> types = {
      revolute, prismatic, point_contact, cam, rigid, gear, cable, screws};
  if (space == Space::planar) {
    types.push_back(pin_in_slot);
  } else {
    types.insert(
        types.end(),
        {helical, cylindrical, universal, spherical, planar, line_contact, sphere_in_tube});
  }
  if (completeness == Completeness::any) {
    types.insert(types.end(), {rack, clutch, brake});
    if (space == Space::spatial) {
      types.insert(types.end(), {bevel_gear, worm});
    }
  }
  return types;
}

int usual_freedoms(CouplingType type, Space space) {
  switch (type) {
    case rigid:
      return 0;
    case cylindrical:
    case universal:
    case pin_in_slot:
      return 2;
    case spherical:
    case planar:
    case screws:
      return space == Space::planar ? 1 : 3;
    case line_contact:
    case sphere_in_tube:
      return 4;
    case point_contact:
    case cam:
    case cable:
      return space == Space::planar ? 2 : 5;
    default:
      return 1;
  }
}

std::vector<NetworkKey> draw_keys(CouplingType type, Completeness completeness, LayoutDraw& draw) {
  constexpr double kPlaced = 0.8;  // of those that need no point
  switch (type) {
    case revolute:
    case cylindrical:
    case sphere_in_tube:
    case clutch:
    case brake:
    case torque_converter:
      return about_axis(draw);
    case prismatic:
      return along("axis", draw.sliding(), kPlaced, draw);
    case helical:
      return helical_keys(draw);
    case universal:
      return universal_keys(draw);
    case spherical:
      return {at(draw.layout() == Layout::spherical ? draw.centre() : draw.point())};
    case planar:
      return along("normal", draw.turning(), kPlaced, draw);
    case point_contact:
    case cam:
      return along("normal", draw.sliding(), 1.0, draw);
    case line_contact:
      return line_contact_keys(draw);
    case pin_in_slot:
      return along("slot", draw.sliding(), 1.0, draw);
    case rigid:
      return draw.random().chance(kPlaced) ? Keys{at(draw.point())} : Keys{};
    case gear:
      return gear_keys(completeness, draw);
    case bevel_gear:
      return bevel_gear_keys(draw);
    case worm:
      return worm_keys(draw);
    case rack:
      return rack_keys(draw);
    case cable:
      return cable_keys(draw);
    case screws:
      return draw_screw_lists(completeness, draw);
  }
  return {};
}

}  // namespace kinestat
