// The law of one friction as a function of the actions.
#pragma once

#include <vector>

#include "studies/sensitivity/internal/factored_side.hpp"

namespace kinestat {

/// A number that the actions of a case make: its value, and what each self-stress would add.
struct Made {
  Dual value;
  std::vector<Dual> open;

  AdjointSolution adjoint;  ///< of its slopes by the actions
};

/// One friction: its law, and the forces in it that are zero. There |R| has a corner.
struct FrictionForce {
  CouplingId coupling;
  Made magnitude;
  std::vector<Made> corners;
  Change push;  ///< on the right-hand side, for a friction of 1
};

Wrench values_of(const WrenchOf<Dual>& wrench);

/// The frictions of a case, the actions being at `magnitudes`; `open` are those of the
/// self-stresses.
std::vector<FrictionForce> read_friction_forces(const DualCase& values,
                                                const FactoredSide& equations,
                                                const std::vector<double>& magnitudes,
                                                const std::vector<std::vector<double>>& open);

}  // namespace kinestat
