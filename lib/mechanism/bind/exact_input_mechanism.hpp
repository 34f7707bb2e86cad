// The numbers of a mechanism as typed, without rounding.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "math/numbers/exact_input.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// The coordinates of a twist [ω; v_O] or a wrench [T_O; F].
using ExactInputScrew = std::array<ExactInput, 6>;

/// The numbers of a case without rounding. Lists are parallel to those of the Case.
struct ExactInputCase {
  std::vector<ExactInput> motions;     ///< the primary motions [rad/s or m/s]
  std::vector<ExactInput> actions;     ///< the primary actions [N·m or N]
  std::vector<ExactInputScrew> loads;  ///< about the origin of the geometry
};

/// The screws and cases of a Mechanism without rounding, in lists parallel to its own.
struct ExactInputMechanism {
  std::vector<ExactInputScrew> motions;       ///< the unit motion of each freedom
  std::vector<ExactInputScrew> actions;       ///< the unit screw of each action
  std::vector<ExactInputScrew> other_flanks;  ///< the screws of Geometry::other_flanks
  std::vector<ExactInputCase> cases;
};

/// Binds the description again without rounding. `mechanism` must be what bind made of it.
/// Directions are divided by their length, so that they are exact if the length is. Empty iff an
/// error was added: a number can no longer be evaluated, such as the root of a number that is
/// positive only by rounding, or it has a value only by rounding (E0316).
std::optional<ExactInputMechanism> bind_exact_input(const MechanismDescription& description,
                                                    const Mechanism& mechanism,
                                                    Diagnostics& found);

}  // namespace kinestat
