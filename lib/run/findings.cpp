#include "run/findings.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/text.hpp"
#include "run/internal/action_findings.hpp"
#include "run/internal/known_side.hpp"

namespace kinestat {

namespace {

// The state of the shift table that the case is; null if it is none.
const ShiftState* find_state(const Analysis& analysis, const CaseAnalysis& one) {
  if (!analysis.shift) {
    return nullptr;
  }
  const std::vector<NamedShiftState>& states = analysis.shift->solution.states;
  const auto state = std::ranges::find(states, one.which.label, &NamedShiftState::name);
  const bool is_gear = state != states.end() && state->state.kind == ShiftClass::gear;
  return is_gear ? &state->state : nullptr;
}

// A gear may leave freedoms beside it: the shift table says so.
bool is_idle_gear(const Analysis& analysis, const CaseAnalysis& one) {
  const ShiftState* state = find_state(analysis, one);
  return state != nullptr && state->idle > 0;
}

// Elements that follow from each other leave their torques open: the shift table says so.
bool is_open_gear(const Analysis& analysis, const CaseAnalysis& one) {
  const ShiftState* state = find_state(analysis, one);
  return state != nullptr && !state->surplus.empty() &&
         one.action->status == SolveStatus::underdetermined;
}

void add_motion_findings(const Analysis& analysis, const CaseAnalysis& one, Diagnostics& found) {
  const KinematicSolution& motion = *one.motion;
  const KnownSide side = motion_side(analysis, one.which);
  if (motion.status == SolveStatus::dependent) {
    found.error("E0502",
                place_of_surplus(one.which.motions, motion.check, one.which.where),
                fmt::format("case '{}' gives motions that depend on each other: {}",
                            one.which.label,
                            circuits_text(analysis, motion, side)),
                removal_text(motion.check, side) +
                    (motion.check.missing > 0
                         ? fmt::format(", and {}", completions_text(motion.check, side))
                         : ""));
  } else if (motion.status == SolveStatus::overflow) {
    found.error("E0503",
                one.which.where,
                fmt::format("case '{}': velocities are too large for a number", one.which.label),
                "give smaller motions; the answer is proportional to them");
  } else if (motion.status == SolveStatus::underdetermined && !is_idle_gear(analysis, one)) {
    found.error("E0501",
                one.which.where,
                fmt::format("case '{}' knows {} of the {} motions needed (net degree of freedom "
                            "{}); undetermined are {}",
                            one.which.label,
                            one.which.motions.size(),
                            motion.counts.net_freedom,
                            motion.counts.net_freedom,
                            plain_list(names_of(motion.check.undetermined, side))),
                completions_text(motion.check, side));
  }
}

// At the coupling of the output.
void add_locking(const Analysis& analysis, const CaseAnalysis& one, Diagnostics& found) {
  const Topology& topology = analysis.mechanism.topology;
  const ActuatorTopology& output =
      topology.actuators[static_cast<std::size_t>(one.which.outputs.front())];
  const CouplingId coupling = topology.freedoms[static_cast<std::size_t>(output.freedom)].coupling;
  const TransmissionEfficiency& efficiency = *one.efficiency;
  found.warning(
      "W0702",
      topology.coupling(coupling).where,
      fmt::format("case '{}' is self-locking: {}, so output '{}' cannot be driven like that",
                  one.which.label,
                  efficiency.carrier.reason,
                  output.name),
      efficiency.carrier_backward.value
          ? fmt::format(
                "driven by the output, its efficiency is {:.6g}; that may be what is wanted",
                *efficiency.carrier_backward.value)
          : "that may be what is wanted; smaller losses or another ratio would let it turn");
}

// Once for the file: no motion moves the axes to another body.
void add_missing_carriers(const Analysis& analysis, Diagnostics& found) {
  for (const CaseAnalysis& one : analysis.cases) {
    if (!one.efficiency || one.efficiency->without_carrier.empty()) {
      continue;
    }
    for (const CouplingId mesh : one.efficiency->without_carrier) {
      const CouplingTopology& coupling = analysis.mechanism.topology.coupling(mesh);
      found.warning("W0701",
                    coupling.where,
                    fmt::format("the loss of mesh '{}' is not known, since no one body holds the "
                                "axes of its gears",
                                coupling.name),
                    "join each of them to its carrier by a coupling of type revolute, or take the "
                    "mesh out of 'losses'");
    }
    return;
  }
}

}  // namespace

void add_findings(const Analysis& analysis, Diagnostics& found) {
  for (const CaseAnalysis& one : analysis.cases) {
    if (one.motion) {
      add_motion_findings(analysis, one, found);
    }
    if (one.action && !is_open_gear(analysis, one)) {
      add_action_findings(analysis, one, found);
    }
    const bool is_locked_anyway = one.power && one.power->is_self_locking;
    if (is_locked_anyway) {
      found.warning("W0602",
                    one.which.where,
                    fmt::format("case '{}' is self-locking: friction takes more than the input "
                                "gives, so the output must drive too",
                                one.which.label),
                    "in this direction nothing moves by itself; that may be what is wanted");
    }
    if (one.efficiency && one.efficiency->carrier.is_self_locking && !is_locked_anyway) {
      add_locking(analysis, one, found);
    }
    if (one.power && !one.power->is_balanced) {
      found.error("E0701",
                  one.which.where,
                  fmt::format("case '{}': the powers sum to {:.3g} of the largest instead of zero",
                              one.which.label,
                              one.power->balance_residual),
                  "the position is close to singular, or the scales are too far apart");
    }
  }
  add_missing_carriers(analysis, found);
}

}  // namespace kinestat
