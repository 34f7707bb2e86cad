// What parameters change in the equations of a case.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "math/elimination/elimination.hpp"
#include "screw/coordinate_basis.hpp"
#include "studies/sensitivity/dual_case.hpp"
#include "studies/sensitivity/internal/sum.hpp"

namespace kinestat {

/// A right-hand side, or a change of it that a parameter causes, per SI unit of it.
struct Change {
  std::vector<std::pair<int, double>> rows;  ///< row of the equations, change
  std::vector<double> known;                 ///< of the primaries, in the units of the unknowns

  bool is_nothing() const;
};

/// What parameters change, each in one Change. Nobody knows the size of a self-stress that is open,
/// so a value that one of them would move has no derivative.
struct ParameterChanges {
  std::vector<Change> total;
  std::vector<bool> is_possible;             ///< whether the change has a size at all
  std::vector<std::vector<double>> open;     ///< magnitudes of each self-stress
  std::vector<std::vector<Change>> by_open;  ///< what the parameters change under it
  std::size_t completed_count = 0;           ///< the first of these are not open but completed
};

/// Adds what a value moves by, if the right-hand side changes so.
void add(const AdjointSolution& adjoint, const Change& change, Sum& sum);

/// Whether a value moves with the right-hand side, and beside that by `directly`, by more than the
/// rounding of all.
bool moves(const AdjointSolution& adjoint, const Change& change, double directly = 0.0);

/// Of each parameter, in the equations of the motions.
std::vector<Change> motion_changes(const DualCase& values, const CoordinateBasis& basis);

/// The right-hand side of the equilibrium: primary actions, loads and frictions.
Change known_actions(const DualCase& values, const CoordinateBasis& basis);

/// How each parameter changes the primary actions and the loads.
std::vector<Change> known_action_changes(const DualCase& values, const CoordinateBasis& basis);

/// Adds a wrench on the head of a coupling, and its opposite on the tail.
void add_pair(const CouplingTopology& coupling,
              const Wrench& wrench,
              const CoordinateBasis& basis,
              Change& change);

/// Adds how each parameter, and nothing else, changes such a pair of wrenches of that size.
void add_pair_changes(const CouplingTopology& coupling,
                      const WrenchOf<Dual>& unit,
                      double size,
                      const CoordinateBasis& basis,
                      std::vector<Change>& changes);

/// Adds to `changes` how each parameter changes the wrenches of actions of these magnitudes.
void add_action_changes(std::span<const double> magnitudes,
                        const DualCase& values,
                        const CoordinateBasis& basis,
                        std::vector<Change>& changes);

}  // namespace kinestat
