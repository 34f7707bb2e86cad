// Screws of pitch, and those that the file gives directly.
#pragma once

#include "couplings/internal/catalogue_row.hpp"

namespace kinestat {

/// A rotation about the axis with a velocity of h along it.
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

}  // namespace kinestat
