// States of a sweep by tapes: the numbers of a state alone, without a file, a name or a report.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mechanism/rebind.hpp"
#include "report/sweep_rows.hpp"
#include "sweep/network_tape.hpp"
#include "sweep/state_walk.hpp"

namespace kinestat {

struct SweepTask;

/// What the tapes of one case are asked for.
struct TapedCase {
  std::optional<NetworkTape> motion;
  std::optional<NetworkTape> action;
  std::vector<int> freedoms;  ///< the wanted ones
  std::vector<int> actions;   ///< likewise
};

/// The tapes of all cases of a sweep; shared by the workers.
struct SweepTapes {
  Rebinder rebinder;
  std::vector<TapedCase> cases;
};

/// Empty where the states of a sweep must be analysed one by one: a quantity needs the power flow,
/// a case has no answer with the parameters of the file, or the parameters move more than couplings
/// and primaries, or freewheels shift. What was recorded is compared with whole analyses of some
/// states before it is trusted.
std::optional<SweepTapes> record_tapes(const SweepTask& task);

/// Each worker has its own.
class TapedSolver {
 public:
  /// Both must outlive it.
  TapedSolver(const SweepTask& task, const SweepTapes& tapes);

  /// Fills the rows of the state, one a case. False where the tapes have no answer for it: it must
  /// be analysed as a whole.
  bool solve(const StateWalk& walk, std::span<SweepRow> rows);

 private:
  struct Work {
    EliminationTape::Workspace motion;
    EliminationTape::Workspace action;
  };

  bool decide_gears(std::span<SweepRow> rows);
  bool is_no_gear(std::size_t i) const;
  bool drives_output(std::size_t i) const;
  bool solve_case(std::size_t i);
  bool solve_motion(std::size_t i);
  bool solve_action(std::size_t i);

  const SweepTask& task_;
  const SweepTapes& tapes_;
  Rebinder rebinder_;
  Mechanism mechanism_;  ///< with the geometry of the state
  std::vector<Case> all_cases_;
  bool has_combinations_ = false;  ///< that are no gears with the parameters of the file
  std::vector<CaseAnalysis> analyses_;
  std::vector<Work> work_;
  std::vector<double> known_;
  std::vector<double> wanted_;
};

}  // namespace kinestat
