// The values that only couplings have: places, screws, frictions.
#pragma once

#include <optional>
#include <vector>

#include "couplings/kind.hpp"
#include "forms/form.hpp"

namespace kinestat {

/// Whether it is a list of two.
bool is_pair(const YamlNode& node);

/// One point, a point for each of the two bodies, or a number along the axis.
Form<CouplingPoint> coupling_point();

/// {TAIL: point, HEAD: point}: one of each of two bodies.
Form<std::vector<std::pair<Name, PointDescription>>> points_of_bodies();

/// [tail, head].
Form<std::vector<Name>> coupling_ends();

/// Exactly two; a radius that is not there is that of a flat body.
Form<std::vector<std::optional<Value>>> contact_radii();

/// Which flank of teeth carries their load.
Form<Flank> flank_of_teeth();

/// A rotation or a translation.
Form<ScrewDescription> motion_screw();
Form<std::vector<ScrewDescription>> motion_screws();

/// A force or a couple.
Form<std::vector<ScrewDescription>> action_screws();

/// A mapping or, but for a journal or thread, a coefficient alone.
Form<FrictionDescription> friction_of(FrictionKind kind);

/// Of a torque converter.
Form<CharacteristicDescription> characteristic();

/// A mapping of actions to values.
Form<std::vector<StiffnessDescription>> stiffness_of_actions();

}  // namespace kinestat
