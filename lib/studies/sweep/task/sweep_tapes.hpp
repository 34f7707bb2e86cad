// The tape of a sweep: from the parameters of a state to what its rows hold.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "math/tapes/lane_tape.hpp"
#include "mechanism/bind/rebind.hpp"
#include "studies/sweep/task/bound_numbers.hpp"
#include "studies/sweep/task/case_tape.hpp"
#include "studies/sweep/task/sweep_notes.hpp"

namespace kinestat {

class StateRules;
struct SweepTask;

/// Shared by the workers.
struct SweepTapes {
  std::optional<Rebinder> rebinder;         ///< empty: every state is bound as a whole,
  std::optional<BoundNumbers> bound;        ///< and gives these
  std::shared_ptr<const StateRules> rules;  ///< of what is not bound anew
  LaneTape tape;
  std::vector<SweepInput> inputs;  ///< of the tape, parallel to its own
  bool needs_geometry = false;     ///< some of them are coordinates of screws
  bool needs_primaries = false;    ///< or magnitudes of primaries
  std::vector<CaseTape> cases;  ///< of each case of the task; empty where a combination is no gear
};

/// Empty where the states of a sweep must be analysed one by one: a case has no answer with the
/// parameters of the file, or loads, friction or cables on pulleys, or freewheels shift. Where the
/// parameters move more than couplings and primaries, as the teeth of `gears` do, each state is
/// bound as a whole and the tape solves it. What was recorded is compared with mechanisms bound as
/// a whole in some states before it is trusted.
std::optional<SweepTapes> record_tapes(const SweepTask& task);

}  // namespace kinestat
