// All states of a transmission: which combination of elements makes which gear.
#pragma once

#include <string>
#include <vector>

#include "studies/shift/shift_state.hpp"
#include "studies/shift/shift_table.hpp"

namespace kinestat {

/// Beyond this many combinations nobody reads a table; a sweep asks for single states.
inline constexpr double kMostCombinations = 5000;

/// Which combinations are asked for beside those of the plan.
struct ShiftOptions {
  bool one_more = false;
  bool one_fewer = false;
};

struct NamedShiftState {
  std::string name;          ///< the label, or the elements joined with '+', or kNothingEngaged
  std::vector<int> engaged;  ///< indices into ShiftPlan::elements, ascending
  SourceRange where;         ///< of the label, or of the section
  ShiftState state;
  std::string reason;  ///< why it is no gear, or what a gear leaves free

  /// Those of `engaged` that don't slip: without freewheels that overrun; ascending.
  std::vector<int> holding() const;
};

struct ShiftSolution {
  int net_freedom = 0;         ///< F_N of the open train
  int needed = 0;              ///< elements that a gear engages
  int following = 0;           ///< elements that it may engage more, as inputs follow from others
  double possibilities = 0.0;  ///< C(N, needed) (Cazangi 2008, eq. 5.4), of all such numbers
  bool is_too_long = false;    ///< more than kMostCombinations were asked for: there are no states
  double asked = 0.0;          ///< how many were asked for
  std::vector<NamedShiftState> states;  ///< in the order of the table
  ShiftTable table;
};

/// The rate that ratios refer to: that of all inputs, or of the first one where a machine reacts
/// and those of the others follow from it. Empty where they differ, or may.
std::optional<double> reference_rate(const ShiftPlan& plan, const ShiftState& state);

/// Combinations of k out of n; infinite if there are too many for a number.
double combination_count(int n, int k);

/// Every combination of the size that the mobility asks for, unless the plan asks for those with a
/// label alone, where a machine reacts also those in which inputs follow from each other; those of
/// one more and one fewer if asked for, and whatever has a label; gears by
/// falling ratio, then those in reverse, then what is no gear, in the order of the elements.
[[nodiscard]] ShiftSolution find_shift_solution(const Mechanism& mechanism,
                                                const CoordinateBasis& basis,
                                                const ShiftPlan& plan,
                                                const ShiftOptions& options);

}  // namespace kinestat
