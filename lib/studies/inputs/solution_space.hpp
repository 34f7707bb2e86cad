// What the equations of one side leave possible.
#pragma once

#include <vector>

#include "math/elimination/rank.hpp"
#include "mechanism/mechanism.hpp"
#include "screw/coordinate_basis.hpp"

namespace kinestat {

/// All motions that the couplings allow, or all actions in equilibrium without load: the columns of
/// `basis` times any factors.
struct SolutionSpace {
  MatX basis;                 ///< one row a magnitude in `units`, one column a solution
  std::vector<double> units;  ///< SI per unit: what holds a length counts in the mechanism's size
  RankEvidence evidence;      ///< of the system whose null space it is

  int dimension() const { return static_cast<int>(basis.cols()); }
};

/// Rows are the freedoms, as many columns as F_N.
SolutionSpace motion_space(const Mechanism& mechanism, const CoordinateBasis& coordinates);

/// Rows are the actions, as many columns as C_N.
SolutionSpace action_space(const Mechanism& mechanism, const CoordinateBasis& coordinates);

}  // namespace kinestat
