// How the gears of a transmission follow each other.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace kinestat {

/// A gear as the table sees it.
struct TableGear {
  int state = 0;                ///< index into ShiftSolution::states
  std::optional<double> ratio;  ///< ω_in/ω_out of the inputs, if they turn alike, and
                                ///< the first output
  std::vector<int> engaged;     ///< ascending
};

/// A change of gear in which one element opens and one engages, or one does either.
struct GearChange {
  int from = 0;  ///< states; the change back exchanges them
  int to = 0;
  int opens = -1;  ///< element; -1: none
  int engages = -1;
};

/// Lists of states are indices into ShiftSolution::states.
struct ShiftTable {
  std::vector<std::optional<double>> steps;    ///< of each gear, in their order: ratio of the next
                                               ///< lower gear / its own; empty for the first and
                                               ///< for reverse gears
  std::optional<double> span;                  ///< ratio of the first / ratio of the last forward
                                               ///< gear; empty with fewer than two
  std::vector<std::vector<int>> equal_ratios;  ///< gears of one ratio by different elements
  std::vector<GearChange> changes;
  double forward = 1.0;  ///< the sign of the ratios of forward gears
};

/// The sign of the ratios of forward gears: what most gears have, plus if there are as many.
double find_forward_sign(std::span<const TableGear> gears);

/// The order of the table: forward gears by falling size of their ratio, then reverse gears
/// likewise, then those without a ratio; equal ones stay in their order. `forward` is the sign of
/// the first.
void sort_gears(std::vector<TableGear>& gears, double forward);

/// Of gears that were sorted with this sign. Ratios that differ by rounding are equal.
ShiftTable make_shift_table(std::span<const TableGear> gears, double forward);

}  // namespace kinestat
