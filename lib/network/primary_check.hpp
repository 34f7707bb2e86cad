// Whether a choice of primary magnitudes is right, and what to choose instead.
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

/// A relation that the primary magnitudes must satisfy: sum of coefficient · magnitude [SI] =
/// constant. Loads make the constant.
struct Dependence {
  std::vector<DependenceTerm> terms;
  std::vector<int> equations;  ///< rows of the system that combine to it, ascending
  double constant = 0.0;
  double constant_size = 0.0;  ///< sum of the sizes of what was summed into the constant
};

/// What is wrong with the primary magnitudes of a case; all empty if nothing is.
struct PrimaryCheck {
  std::vector<Dependence> dependences;
  /// Sets of primaries without which the others are independent, one magnitude a dependence: all
  /// of them where there is one dependence, otherwise up to five.
  std::vector<std::vector<int>> removals;
  /// Magnitudes that remain undetermined, ascending; also those that move very little, if it is
  /// more than the rounding of the numbers may cause: rather no value than a wrong one.
  std::vector<int> undetermined;
  /// Those of them that are large enough to be chosen as primaries.
  std::vector<int> candidates;
  /// How many more primaries are needed.
  int missing = 0;
  /// Up to five sets of magnitudes, each of which would complete the choice, those of actuators
  /// first; none if very many are missing.
  std::vector<std::vector<int>> completions;
};

/// Reads the check off an elimination whose last columns were the primaries. Magnitude i is column
/// `blocks.first_column` + i, which counts in `units`[i] (SI). `rhs` is the right-hand side of the
/// system; empty: zero. `driven` are the magnitudes of actuators, which an engineer would give:
/// they are proposed first and removed last.
PrimaryCheck check_primaries(const Elimination& elimination,
                             const InexactBlocks& blocks,
                             std::span<const double> units,
                             std::span<const double> rhs = {},
                             std::span<const int> driven = {});

}  // namespace kinestat
