// Checks a choice of primary magnitudes, and proposes what to choose instead.
#pragma once

#include <span>
#include <vector>

#include "math/elimination/data_zero.hpp"

namespace kinestat {

/// A term of a relation between primary magnitudes.
struct DependenceTerm {
  int index = 0;  ///< freedom or action
  double coefficient = 0.0;
};

/// A relation that the primary magnitudes must satisfy: the sum of coefficient · magnitude [SI] is
/// equal to the constant, which comes from the loads.
struct Dependence {
  std::vector<DependenceTerm> terms;
  std::vector<int> equations;  ///< the rows of the system that combine to this relation, ascending
  double constant = 0.0;
  double constant_size = 0.0;  ///< sum of the absolute values of the terms of the constant
};

/// What is wrong with the primary magnitudes of a case. All lists are empty if nothing is.
struct PrimaryCheck {
  std::vector<Dependence> dependences;
  /// Sets of primaries whose removal makes the others independent; a set has one magnitude per
  /// dependence. All such sets if there is one dependence, otherwise up to five.
  std::vector<std::vector<int>> removals;
  /// Magnitudes that remain undetermined, ascending. A magnitude that can change only very little
  /// is among them if this is more than rounding may cause: no value is better than a wrong one.
  std::vector<int> undetermined;
  /// The undetermined magnitudes that change enough to be chosen as primaries.
  std::vector<int> candidates;
  /// How many more primaries are needed.
  int missing = 0;
  /// Up to five sets of magnitudes, each of which would complete the choice, those of actuators
  /// first; none if very many are missing.
  std::vector<std::vector<int>> completions;
};

/// Derives the check from an elimination whose last columns were the primaries. Magnitude i is
/// column `blocks.first_column` + i, in units of `units`[i] (SI). `rhs` is the right-hand side of
/// the system; empty means zero. `driven` are the magnitudes of actuators, which an engineer would
/// give: they are proposed first and removed last.
PrimaryCheck check_primaries(const Elimination& elimination,
                             const InexactBlocks& blocks,
                             std::span<const double> units,
                             std::span<const double> rhs = {},
                             std::span<const int> driven = {});

}  // namespace kinestat
