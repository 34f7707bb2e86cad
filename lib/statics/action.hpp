// Actions from primary actions and loads by Davies' method.
#pragma once

#include <span>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "screw/coordinate_basis.hpp"
#include "statics/equilibrium.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// Solves A_N ψ + loads = 0 for the secondary actions, given the primary ones (Cazangi 2008,
/// sections 3.8.2 and 3.9.2), on the equilibrium of the bodies, which has the same solutions.
/// `basis` must hold all unit actions and the loads. The status is `inconsistent` if the primaries
/// or the loads act on a freedom that nothing resists, `dependent` if the primaries follow from
/// each other and the loads, `underdetermined` (and then partly filled) if there are too few.
/// `ties` replace the equations of the tensions that they tie.
[[nodiscard]] StaticSolution solve_action(const Mechanism& mechanism,
                                          const CoordinateBasis& basis,
                                          std::span<const Primary> primaries,
                                          std::span<const BodyWrench> loads = {},
                                          const AccuracyRequest& request = {},
                                          const std::vector<TiedTension>& ties = {});

}  // namespace kinestat
