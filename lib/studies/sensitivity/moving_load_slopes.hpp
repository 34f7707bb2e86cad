// How the forces of inertia and of springs of a case move with the parameters.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "dynamics/case_dynamics.hpp"
#include "studies/sensitivity/dual_case.hpp"

namespace kinestat {

/// Why that is not known.
struct LoadSlopeObstacle {
  std::optional<CouplingId> coupling;  ///< how it moves its bodies on is not differentiated; none:
                                       ///< their accelerations are not those of lower pairs
};

/// Of the loads that a solved case has behind those of the file, in that order: springs, then
/// inertia. `values` knows the motion, if the case has one, and of the case what `solved` was made
/// of; `dynamics` is null of a case without inertia. Nothing may follow curves. A slope is NaN
/// where the velocities have none.
std::variant<std::vector<WrenchOf<Dual>>, LoadSlopeObstacle> moving_load_slopes(
    const DualCase& values, const CaseDynamics* dynamics);

}  // namespace kinestat
