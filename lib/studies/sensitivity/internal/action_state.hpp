// The actions of a case, and the self-stresses that equilibrium leaves open.
#pragma once

#include <cstddef>
#include <vector>

#include "studies/sensitivity/internal/factored_side.hpp"

namespace kinestat {

/// All in N·m and N.
struct ActionState {
  std::vector<double> magnitudes;             ///< in equilibrium; where open, one choice of many
  std::vector<std::vector<double>> stresses;  ///< a basis
  std::size_t completed_count = 0;  ///< of the stresses, the first: stiffness or the least norm
                                    ///< determines their size
};

/// `equations` are those of the equilibrium.
ActionState find_action_state(const DualCase& values, const FactoredSide& equations);

}  // namespace kinestat
