// One state of a sweep after the other: parameters in, rows out.
#pragma once

#include <span>
#include <vector>

#include "report/sweep_rows.hpp"
#include "run/internal/sweep_task.hpp"
#include "sweep/state_walk.hpp"

namespace kinestat {

/// Binds the description with the parameters of states.
class StateBinder {
 public:
  explicit StateBinder(const SweepTask& task);

  /// Empty where the state has no mechanism; the code of its first error is then kept.
  std::optional<Mechanism> bind(const Slots& slots);

  std::string_view code() const { return code_; }

  /// That of the last state.
  const MechanismDescription& description() const { return description_; }

 private:
  const SweepTask& task_;
  MechanismDescription description_;
  std::string_view code_;
};

/// Each worker has its own. The numbers of a row are those that an analysis with --set gives; where
/// a tape gives them, up to the rounding that another order of pivots makes.
class StateSolver {
 public:
  /// The task must outlive it.
  explicit StateSolver(const SweepTask& task);

  /// The rows of the state at which the walk stands, one a case.
  std::span<const SweepRow> solve(const StateWalk& walk);

 private:
  void analyse(const StateWalk& walk);
  void decide_gears(const Mechanism& mechanism, std::vector<Case>& cases);
  void check_tape(const StateWalk& walk);
  void fail(std::string_view status);

  const SweepTask& task_;
  StateBinder binder_;
  std::optional<TapedSolver> taped_;
  std::vector<SweepRow> rows_;
  std::vector<std::optional<ShiftState>> states_;  ///< of each row that is of a combination
};

/// Of the ratio of a gear in SI; empty of any other case, and where a state is no gear.
std::optional<double> gear_ratio(const SweepTask& task, std::size_t row, const CaseAnalysis& one);

/// Writes the quantities of a case into its row; one that it does not have is a NaN.
void fill_row(const SweepTask& task,
              const Mechanism& mechanism,
              const CaseAnalysis& one,
              SweepRow& row);

/// What the status of a row says of a case: that of its motion, of its actions where they are asked
/// for, or why it has no ratio. What is known suffices and is independent with the parameters of
/// the file if `is_usually_solved`: then a state in which it is not stands in a singular position.
std::string_view row_status(const CaseAnalysis& one, const SweepTask& task, bool is_usually_solved);

}  // namespace kinestat
