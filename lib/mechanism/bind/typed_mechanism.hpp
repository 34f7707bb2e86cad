// The numbers of a mechanism as typed.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "math/numbers/typed.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// [ω; v_O] or [T_O; F]
using TypedScrew = std::array<Typed, 6>;

/// Lists are parallel to those of a Case.
struct TypedCase {
  std::vector<Typed> motions;     ///< primary ones [rad/s or m/s]
  std::vector<Typed> actions;     ///< primary ones [N·m or N]
  std::vector<TypedScrew> loads;  ///< about the origin of the geometry
};

/// Beside a Mechanism, the same screws and cases without rounding; lists are parallel.
struct TypedMechanism {
  std::vector<TypedScrew> motions;       ///< of the unit motion of each freedom
  std::vector<TypedScrew> actions;       ///< the unit action
  std::vector<TypedScrew> other_flanks;  ///< of geometry.other_flanks
  std::vector<TypedCase> cases;
};

/// Reads the description again; `mechanism` must be what bind made of it. Directions have length
/// one, so that they are exact where their length is. Empty if the description no longer evaluates,
/// as a root of what is zero but for rounding.
std::optional<TypedMechanism> bind_typed(const MechanismDescription& description,
                                         const Mechanism& mechanism);

}  // namespace kinestat
