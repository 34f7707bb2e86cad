// What parameters change in the equations of a case.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "math/elimination.hpp"
#include "screw/coordinate_basis.hpp"
#include "sensitivity/dual_case.hpp"
#include "sensitivity/internal/sum.hpp"

namespace kinestat {

/// A right-hand side, or a change of it that a parameter causes, per SI unit of it.
struct Change {
  std::vector<std::pair<int, double>> rows;  ///< row of the equations, change
  std::vector<double> known;                 ///< of the primaries, in the units of the unknowns

  bool is_nothing() const;
};

/// Adds what a value moves by, if the right-hand side changes so.
void add(const AdjointSolution& adjoint, const Change& change, Sum& sum);

/// Whether a value moves with the right-hand side by more than the rounding of both.
bool moves(const AdjointSolution& adjoint, const Change& change);

/// Of each parameter, in the equations of the motions.
std::vector<Change> motion_changes(const DualCase& values, const CoordinateBasis& basis);

/// What the case knows: primary actions and loads. Their right-hand side itself, and how each
/// parameter changes it.
Change known_actions(const DualCase& values, const CoordinateBasis& basis);
std::vector<Change> known_action_changes(const DualCase& values, const CoordinateBasis& basis);

/// Adds to `changes` how each parameter changes the wrenches of actions of these magnitudes.
void add_action_changes(std::span<const double> magnitudes,
                        const DualCase& values,
                        const CoordinateBasis& basis,
                        std::vector<Change>& changes);

}  // namespace kinestat
