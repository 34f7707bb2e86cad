// The values that only couplings have: places, screws, frictions.
#pragma once

#include <optional>
#include <vector>

#include "couplings/kind.hpp"
#include "format/form.hpp"

namespace kinestat {

/// Whether it is a list of two.
bool is_pair(const YamlNode& node);

/// One point, a point for each of the two bodies, or a number along the axis.
Form<CouplingPoint> coupling_point();

/// [tail, head].
Form<std::vector<Name>> coupling_ends();

/// Exactly two; a radius that is not there is that of a flat body.
Form<std::vector<std::optional<Value>>> contact_radii();

Form<ScrewDescription> screw();

Form<std::vector<ScrewDescription>> screw_list();

/// A mapping or, but for a journal or thread, a coefficient alone.
Form<FrictionDescription> friction_of(FrictionKind kind);

/// A mapping of actions to values.
Form<std::vector<StiffnessDescription>> stiffness_of_actions();

}  // namespace kinestat
