// How the frictions of a case move with the parameters.
#pragma once

#include <optional>
#include <vector>

#include "studies/sensitivity/internal/adjoint_side.hpp"

namespace kinestat {

/// Derivatives of all rates towards each parameter; empty where there are none.
using RateSlopes = std::vector<std::optional<std::vector<double>>>;

/// Whether the size or the direction of a friction moves with a rate.
bool friction_depends_on_rates(const DualCase& values);

/// Adds the frictions whose size is open to what is open in `changes`, as if each were a
/// self-stress. `rates` may be empty if friction does not depend on them.
void add_open_frictions(const DualCase& values,
                        const FactoredSide& equations,
                        const RateSlopes& rates,
                        ParameterChanges& changes);

/// df/dp [N·m or N per SI unit] of each friction, for each parameter: of f = law(ψ, φ, p) together
/// with the equilibrium, in which frictions act as loads. So it adds them to `changes`, which holds
/// already what else the parameters change there, with the actions at `magnitudes`. A parameter by
/// which a friction has no derivative becomes impossible. `rates` may be empty if friction does not
/// depend on them.
std::vector<std::vector<double>> add_friction_changes(const DualCase& values,
                                                      const FactoredSide& equations,
                                                      const std::vector<double>& magnitudes,
                                                      const RateSlopes& rates,
                                                      ParameterChanges& changes);

}  // namespace kinestat
