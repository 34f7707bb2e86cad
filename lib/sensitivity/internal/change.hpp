// What parameters change in the equations of a case.
#pragma once

#include <utility>
#include <vector>

#include "math/elimination.hpp"
#include "screw/coordinate_basis.hpp"
#include "sensitivity/dual_case.hpp"
#include "sensitivity/internal/sum.hpp"

namespace kinestat {

/// A change of the right-hand side that a parameter causes, per SI unit of it.
struct Change {
  std::vector<std::pair<int, double>> rows;  ///< row of the equations, change
  std::vector<double> known;                 ///< of the primaries, in the units of the unknowns

  bool is_nothing() const;
};

/// Adds what a value moves by, if the right-hand side changes so.
void add(const AdjointSolution& adjoint, const Change& change, Sum& sum);

/// Of each parameter, in the equations of the motions.
std::vector<Change> motion_changes(const DualCase& values, const CoordinateBasis& basis);

/// Of each parameter, in the equilibrium.
std::vector<Change> action_changes(const DualCase& values, const CoordinateBasis& basis);

}  // namespace kinestat
