// The tape of a sweep: from the parameters of a state to what its rows hold.
#pragma once

#include <optional>
#include <vector>

#include "math/tapes/lane_tape.hpp"
#include "mechanism/bind/rebind.hpp"
#include "studies/sweep/task/case_tape.hpp"
#include "studies/sweep/task/sweep_notes.hpp"

namespace kinestat {

struct SweepTask;

/// Shared by the workers.
struct SweepTapes {
  Rebinder rebinder;
  LaneTape tape;
  std::vector<SweepInput> inputs;  ///< of the tape, parallel to its own
  bool needs_geometry = false;     ///< some of them are coordinates
  bool needs_primaries = false;    ///< or magnitudes of primaries
  std::vector<CaseTape> cases;  ///< of each case of the task; empty where a combination is no gear
};

/// Empty where the states of a sweep must be analysed one by one: a quantity needs the power flow,
/// a case has no answer with the parameters of the file, or the parameters move more than couplings
/// and primaries, or freewheels shift. What was recorded is compared with mechanisms bound as a
/// whole in some states before it is trusted.
std::optional<SweepTapes> record_tapes(const SweepTask& task);

}  // namespace kinestat
