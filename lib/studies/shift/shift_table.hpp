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
  std::vector<int> engaged;     ///< ascending; without freewheels that overrun
  std::vector<std::optional<double>> slips = {};  ///< of each element [rad/s]
};

/// A change of gear: one in which one element opens and one engages, or one does either, or that
/// from a forward gear to the next.
struct GearChange {
  int from = 0;  ///< states; the change back exchanges them, and what opens and what engages
  int to = 0;
  std::vector<int> opens;      ///< elements, ascending
  std::vector<int> engages;    ///< likewise
  std::optional<double> step;  ///< ratio of `from` / ratio of `to`, of two forward gears
  /// Sum of the sizes of what those that engage slip before, which they take up [rad/s]; empty
  /// where one of them may slip as it likes.
  std::optional<double> slip;
  std::optional<double> slip_back;  ///< likewise of the change back

  int elements() const { return static_cast<int>(opens.size() + engages.size()); }
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
