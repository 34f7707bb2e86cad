// The states of a sweep, some at a time: parameters in, rows out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "studies/sweep/motion/lane_motions.hpp"
#include "studies/sweep/motion/state_motion.hpp"
#include "studies/sweep/report/sweep_rows.hpp"
#include "studies/sweep/state_walk.hpp"
#include "studies/sweep/task/sweep_task.hpp"
#include "studies/sweep/task/tape_solver.hpp"

namespace kinestat {

/// Binds the description with the parameters of states.
class StateBinder {
 public:
  explicit StateBinder(const SweepTask& task);

  /// Empty where the state of that number has no mechanism; the code of its first error is then
  /// kept.
  std::optional<Mechanism> bind(std::uint64_t state);

  std::string_view code() const { return code_; }

  /// That of the last state.
  const MechanismDescription& description() const { return description_; }

 private:
  const SweepTask& task_;
  MechanismDescription description_;
  std::string_view code_;
};

/// The size of the largest magnitude that a case knows [SI], of rates where the sweep reports any,
/// and likewise of actions.
double largest_known(const SweepTask& task, const Case& which);

/// A state of a sweep that was worked out.
struct SolvedState {
  std::uint64_t number = 0;
  std::span<const std::uint64_t> places;  ///< on the axes
  std::span<const SweepRow> rows;         ///< one a case
};

/// Each worker has its own. The numbers of a row are those that an analysis with --set gives; where
/// a tape gives them, up to the rounding that another order of pivots makes. They do not depend on
/// which states are worked out together.
class StateSolver {
 public:
  /// The task must outlive it. `lanes` is how many states a tape works out together: 1 or kLanes.
  /// Motions are followed one by one, as a whole, if it is 1.
  explicit StateSolver(const SweepTask& task, std::size_t lanes = kLanes);

  /// The next states of the walk, as many as are worked out together; empty at its end. They stay
  /// until the next call.
  std::span<const SolvedState> solve_next(StateWalk& walk);

 private:
  std::span<std::uint64_t> places_of(std::size_t lane);
  std::span<SweepRow> rows_of(std::size_t lane);
  void take(const StateWalk& walk, std::size_t lane, std::size_t count);
  void answer_together(std::size_t count);
  void analyse(std::size_t lane);
  void analyse(std::uint64_t state, bool is_undefined, std::span<SweepRow> rows);
  void solve_position(const Mechanism& mechanism, std::span<SweepRow> rows);
  CaseAnalysis solve_again(const Mechanism& mechanism, std::size_t row, const Case& which);
  void fill_limit_use(const Mechanism& mechanism,
                      std::size_t row,
                      const CaseAnalysis& one,
                      SweepRow& filled) const;
  void decide_gears(const Mechanism& mechanism, std::vector<Case>& cases);
  void check_some(std::size_t count);
  void check_answer(std::uint64_t state, std::span<const SweepRow> answered);
  void clear(std::string_view status, std::span<SweepRow> rows);

  const SweepTask& task_;
  StateBinder binder_;
  std::optional<TapeSolver> taped_;
  std::optional<StateMotion> moved_;
  std::optional<LaneMotions> lanes_;
  std::shared_ptr<const StateRules> lane_rules_;   ///< of what the lanes do not bind
  std::vector<char> is_answered_;                  ///< of each lane: by a tape or in lanes
  std::vector<char> is_undefined_;                 ///< of each lane
  std::vector<std::uint64_t> places_;              ///< of each lane, axis by axis
  std::vector<SweepRow> rows_;                     ///< of each lane, case by case
  std::vector<SolvedState> solved_;                ///< of each lane
  std::optional<ShiftPlan> plan_;                  ///< with the parameters of the last state
  std::vector<std::optional<ShiftState>> states_;  ///< of each row that is of a combination
  std::vector<Quantity> scratch_;
  std::uint64_t unchecked_ = 0;  ///< how many follow before one is analysed both ways
};

/// Of the ratio of a gear in SI; empty of any other case, and where a state is no gear.
std::optional<double> gear_ratio(const SweepTask& task, std::size_t row, const CaseAnalysis& one);

}  // namespace kinestat
