// The numbers of a mechanism as typed.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "math/numbers/exact_input.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// [ω; v_O] or [T_O; F]
using ExactInputScrew = std::array<ExactInput, 6>;

/// Lists are parallel to those of a Case.
struct ExactInputCase {
  std::vector<ExactInput> motions;     ///< primary ones [rad/s or m/s]
  std::vector<ExactInput> actions;     ///< primary ones [N·m or N]
  std::vector<ExactInputScrew> loads;  ///< about the origin of the geometry
};

/// Beside a Mechanism, the same screws and cases without rounding; lists are parallel.
struct ExactInputMechanism {
  std::vector<ExactInputScrew> motions;       ///< of the unit motion of each freedom
  std::vector<ExactInputScrew> actions;       ///< the unit action
  std::vector<ExactInputScrew> other_flanks;  ///< of geometry.other_flanks
  std::vector<ExactInputCase> cases;
};

/// Reads the description again; `mechanism` must be what bind made of it. Directions have length
/// one, so that they are exact where their length is. Empty iff an error was added: the description
/// no longer evaluates, as a root of what is zero but for rounding, or a number has a value by
/// rounding alone (E0316).
std::optional<ExactInputMechanism> bind_exact_input(const MechanismDescription& description,
                                                    const Mechanism& mechanism,
                                                    Diagnostics& found);

}  // namespace kinestat
