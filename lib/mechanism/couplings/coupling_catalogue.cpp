#include "mechanism/couplings/coupling_catalogue.hpp"

#include <algorithm>
#include <cmath>

#include "mechanism/couplings/internal/catalogue_row.hpp"
#include "mechanism/couplings/internal/reciprocal_complement.hpp"
#include "mechanism/couplings/internal/typed_vector.hpp"

namespace kinestat {

namespace {

template <class Scalar>
void fill_revolute(const CouplingGeometryOf<Scalar>& g, CatalogueRow<Scalar>& row) {
  row.turn_along(g.axis, g.at);
  row.bear_all_forces(g.at);
  if (!row.is_planar()) {
    row.bear_couples_across(g.axis);
  }
}

template <class Scalar>
void fill_prismatic(const CouplingGeometryOf<Scalar>& g, CatalogueRow<Scalar>& row) {
  row.slide_along(g.axis);
  row.bear_forces_across(g.axis, g.at);
  row.bear_all_couples();
}

// A rotation about the axis with a velocity of h along it.
template <class Scalar>
TwistOf<Scalar> turn_with_pitch(const Vec3Of<Scalar>& axis,
                                const Vec3Of<Scalar>& at,
                                const Scalar& pitch) {
  return unit_rotation<Scalar>(axis, at) + pitch * unit_translation<Scalar>(axis);
}

template <class Scalar>
WrenchOf<Scalar> force_with_pitch(const Vec3Of<Scalar>& axis,
                                  const Vec3Of<Scalar>& at,
                                  const Scalar& pitch) {
  return unit_force<Scalar>(axis, at) + pitch * unit_couple<Scalar>(axis);
}

template <class Scalar>
void fill_helical(const CouplingGeometryOf<Scalar>& g, CatalogueRow<Scalar>& row) {
  const Vec3Of<Scalar>& axis = g.axis.direction;
  row.add(
      {.name = "w", .is_rotation = true, .screw = turn_with_pitch<Scalar>(axis, g.at, g.pitch)});
  row.bear_forces_across(g.axis, g.at);
  row.add(
      {.name = "Ra", .is_couple = false, .screw = force_with_pitch<Scalar>(axis, g.at, -g.pitch)});
  row.bear_couples_across(g.axis);
}

template <class Scalar>
void fill_cylindrical(const CouplingGeometryOf<Scalar>& g, CatalogueRow<Scalar>& row) {
  row.turn_along(g.axis, g.at);
  row.slide_along(g.axis);
  row.bear_forces_across(g.axis, g.at);
  row.bear_couples_across(g.axis);
}

// The direction perpendicular to two, along the third world axis where both are along one.
template <class Scalar>
AxisOf<Scalar> third_of(const AxisOf<Scalar>& a, const AxisOf<Scalar>& b) {
  if (a.keyword == 0 || b.keyword == 0) {
    return {.direction = unit_along<Scalar>(a.direction.cross(b.direction)), .keyword = 0};
  }
  const int third = 3 - (a.keyword - 'x') - (b.keyword - 'x');
  return {.direction = Vec3Of<Scalar>::Unit(third), .keyword = static_cast<char>('x' + third)};
}

template <class Scalar>
void fill_universal(const CouplingGeometryOf<Scalar>& g, CatalogueRow<Scalar>& row) {
  row.turn_along(g.axis, g.at);
  row.turn_along(g.second, g.at);
  row.bear_all_forces(g.at);
  const AxisOf<Scalar> third = third_of<Scalar>(g.axis, g.second);
  row.bear_couple(name_along('T', third), third.direction);
}

template <class Scalar>
void fill_spherical(const CouplingGeometryOf<Scalar>& g, CatalogueRow<Scalar>& row) {
  row.turn_freely(g.at);
  row.bear_all_forces(g.at);
}

template <class Scalar>
void fill_planar(const CouplingGeometryOf<Scalar>& g, CatalogueRow<Scalar>& row) {
  row.turn_along(g.axis, g.at);
  row.slide_across(g.axis);
  row.bear_force_along(g.axis, g.at);
  row.bear_couples_across(g.axis);
}

template <class Scalar>
void fill_point_contact(const CouplingGeometryOf<Scalar>& g, CatalogueRow<Scalar>& row) {
  row.turn_freely(g.at);
  row.slide_across(g.axis);
  row.bear_force_along(g.axis, g.at);
}

// Named along world axes only if both directions are, as numbers and letters would not mix.
template <class Scalar>
void fill_line_contact(const CouplingGeometryOf<Scalar>& g, CatalogueRow<Scalar>& row) {
  const bool is_along_world = g.axis.keyword != 0 && g.second.keyword != 0;
  const auto named = [&](AxisOf<Scalar> axis) {
    axis.keyword = is_along_world ? axis.keyword : '\0';
    return axis;
  };
  const AxisOf<Scalar> normal = named(g.axis);
  const AxisOf<Scalar> line = named(g.second);
  const AxisOf<Scalar> across = third_of<Scalar>(normal, line);
  row.turn_along(line, g.at);
  row.turn_along(normal, g.at);
  row.slide_along(line);
  row.slide_along(across);
  row.bear_force_along(normal, g.at);
  row.bear_couple(name_along('T', across), across.direction);
}

template <class Scalar>
void fill_sphere_in_tube(const CouplingGeometryOf<Scalar>& g, CatalogueRow<Scalar>& row) {
  row.turn_freely(g.at);
  row.slide_along(g.axis);
  row.bear_forces_across(g.axis, g.at);
}

// In space the pin stays perpendicular to the plane and in it.
template <class Scalar>
void fill_pin_in_slot(const CouplingGeometryOf<Scalar>& g, CatalogueRow<Scalar>& row) {
  CatalogueRow<Scalar> in_plane(Space::planar);
  in_plane.turn_freely(g.at);
  in_plane.slide_along(g.axis);
  in_plane.bear_forces_across(g.axis, g.at);
  const CouplingScrewsOf<Scalar> screws = in_plane.take();
  for (const NamedTwistOf<Scalar>& freedom : screws.freedoms) {
    row.add(freedom);
  }
  row.add(screws.constraints.front());
  if (!row.is_planar()) {
    const AxisOf<Scalar> pin;
    row.bear_force_along(pin, g.at);
    row.bear_couples_across(pin);
  }
}

template <class Scalar>
void fill_rigid(const CouplingGeometryOf<Scalar>& g, CatalogueRow<Scalar>& row) {
  row.bear_all_forces(g.at);
  row.bear_all_couples();
}

template <class Scalar>
void add_freedom(const ScrewGeometryOf<Scalar>& screw, CatalogueRow<Scalar>& row) {
  const Vec3Of<Scalar>& direction = screw.direction.direction;
  if (screw.kind == ScrewWord::translation) {
    row.slide_along(screw.direction);
  } else {
    row.add({.name = name_along('w', screw.direction),
             .is_rotation = true,
             .screw = turn_with_pitch<Scalar>(direction, screw.at, screw.pitch)});
  }
}

template <class Scalar>
void add_constraint(const ScrewGeometryOf<Scalar>& screw, CatalogueRow<Scalar>& row) {
  const Vec3Of<Scalar>& direction = screw.direction.direction;
  if (screw.kind == ScrewWord::couple) {
    row.bear_couple(name_along('T', screw.direction), direction);
  } else {
    row.add({.name = name_along('R', screw.direction),
             .is_couple = false,
             .screw = force_with_pitch<Scalar>(direction, screw.at, screw.pitch)});
  }
}

// Teeth: rolling, or the relative screw that is given; their contact is a point contact.
template <class Scalar>
void fill_teeth(const CouplingGeometryOf<Scalar>& g, CatalogueRow<Scalar>& row) {
  if (g.is_contact) {
    row.turn_freely(g.at);
    row.slide_across({.direction = g.line_of_action, .keyword = 0});
  } else if (g.relative) {
    add_freedom<Scalar>(*g.relative, row);
  } else {
    row.turn_along(g.axis, g.at);
  }
  row.bear_force("Rc", g.line_of_action, g.at);
}

// The tail pulls the head from the end on the head towards the end on the tail.
template <class Scalar>
void fill_cable(const CouplingGeometryOf<Scalar>& g, CatalogueRow<Scalar>& row) {
  const Vec3Of<Scalar> along = unit_along<Scalar>(g.to - g.from);
  if (row.is_planar()) {
    row.turn("w", Vec3Of<Scalar>::UnitZ(), g.from);
    row.turn("w", Vec3Of<Scalar>::UnitZ(), g.to);
  } else {
    const auto [first, second] = transverse_to<Scalar>(along);
    for (const Vec3Of<Scalar>& end : {g.from, g.to}) {
      row.turn("w", first, end);
      row.turn("w", second, end);
    }
    row.turn("w", along, g.to);
  }
  row.bear_force("F", -along, g.to);
}

template <class Scalar>
void fill_listed(const CouplingGeometryOf<Scalar>& g, CatalogueRow<Scalar>& row) {
  for (const ScrewGeometryOf<Scalar>& screw : g.freedoms) {
    add_freedom<Scalar>(screw, row);
  }
  for (const ScrewGeometryOf<Scalar>& screw : g.constraints) {
    add_constraint<Scalar>(screw, row);
  }
  const CouplingScrewsOf<Scalar> given = row.screws();
  if (given.constraints.empty()) {
    for (auto& one : reciprocal_wrenches<Scalar>(given.freedoms, row.is_planar(), g.at)) {
      row.add(std::move(one));
    }
  } else if (given.freedoms.empty()) {
    for (auto& one : reciprocal_twists<Scalar>(given.constraints, row.is_planar(), g.at)) {
      row.add(std::move(one));
    }
  }
}

template <class Scalar>
void write_row(CouplingType type, const CouplingGeometryOf<Scalar>& g, CatalogueRow<Scalar>& row) {
  switch (type) {
    case CouplingType::revolute:
      return fill_revolute<Scalar>(g, row);
    case CouplingType::prismatic:
      return fill_prismatic<Scalar>(g, row);
    case CouplingType::helical:
      return fill_helical<Scalar>(g, row);
    case CouplingType::cylindrical:
      return fill_cylindrical<Scalar>(g, row);
    case CouplingType::universal:
      return fill_universal<Scalar>(g, row);
    case CouplingType::spherical:
      return fill_spherical<Scalar>(g, row);
    case CouplingType::planar:
      return fill_planar<Scalar>(g, row);
    case CouplingType::point_contact:
    case CouplingType::cam:
      return fill_point_contact<Scalar>(g, row);
    case CouplingType::line_contact:
      return fill_line_contact<Scalar>(g, row);
    case CouplingType::sphere_in_tube:
      return fill_sphere_in_tube<Scalar>(g, row);
    case CouplingType::pin_in_slot:
      return fill_pin_in_slot<Scalar>(g, row);
    case CouplingType::rigid:
      return fill_rigid<Scalar>(g, row);
    case CouplingType::gear:
    case CouplingType::bevel_gear:
    case CouplingType::worm:
    case CouplingType::rack:
      return fill_teeth<Scalar>(g, row);
    case CouplingType::clutch:
    case CouplingType::brake:
      return row.turn_along(g.axis, g.at);
    case CouplingType::cable:
      return fill_cable<Scalar>(g, row);
    case CouplingType::screws:
      return fill_listed<Scalar>(g, row);
  }
}

}  // namespace

template <class Scalar>
CouplingScrewsOf<Scalar> coupling_screws(CouplingType type,
                                         Space space,
                                         const CouplingGeometryOf<Scalar>& geometry) {
  CatalogueRow<Scalar> row(space);
  write_row<Scalar>(type, geometry, row);
  return row.take();
}

template <class Scalar>
NamedWrenchOf<Scalar> internal_action(const NamedTwistOf<Scalar>& freedom,
                                      const Vec3In<Scalar>& at) {
  return {.name = freedom.name,
          .is_couple = freedom.is_rotation,
          .screw = freedom.is_rotation ? unit_couple<Scalar>(freedom.screw.angular)
                                       : unit_force<Scalar>(freedom.screw.linear, at)};
}

template CouplingScrewsOf<double> coupling_screws(CouplingType, Space, const CouplingGeometry&);
template CouplingScrewsOf<Dual> coupling_screws(CouplingType,
                                                Space,
                                                const CouplingGeometryOf<Dual>&);
template NamedWrenchOf<double> internal_action(const NamedTwistOf<double>&, const Vec3In<double>&);
template NamedWrenchOf<Dual> internal_action(const NamedTwistOf<Dual>&, const Vec3In<Dual>&);
template CouplingScrewsOf<Typed> coupling_screws(CouplingType,
                                                 Space,
                                                 const CouplingGeometryOf<Typed>&);
template NamedWrenchOf<Typed> internal_action(const NamedTwistOf<Typed>&, const Vec3In<Typed>&);

}  // namespace kinestat
