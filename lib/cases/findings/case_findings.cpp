#include "cases/findings/case_findings.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cases/case_status.hpp"
#include "cases/findings/action_findings.hpp"
#include "cases/findings/known_side.hpp"
#include "cases/findings/limit_findings.hpp"
#include "cases/findings/load_findings.hpp"
#include "core/text.hpp"
#include "core/tolerance.hpp"

namespace kinestat {

namespace {

// The state of the shift table that the case is; null if it is none.
const ShiftState* find_state(const JudgedFile& file, const CaseAnalysis& one) {
  if (!file.shift) {
    return nullptr;
  }
  const std::vector<NamedShiftState>& states = file.shift->solution.states;
  const auto state = std::ranges::find(states, one.which.label, &NamedShiftState::name);
  const bool is_gear = state != states.end() && state->state.kind == ShiftClass::gear;
  return is_gear ? &state->state : nullptr;
}

// Elements that follow from each other leave their torques open: the shift table says so.
bool is_open_gear(const JudgedFile& file, const CaseAnalysis& one) {
  const ShiftState* state = find_state(file, one);
  return state != nullptr && !state->surplus.empty() &&
         one.action->status == SolveStatus::underdetermined;
}

// What a case leaves open without any other body feeling it.
void add_idle_findings(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found) {
  std::vector<std::string> names;
  for (const IdleFreedom& idle : one.motion->idle) {
    for (const BodyId body : idle.bodies) {
      const std::string name = fmt::format("'{}'", file.mechanism.topology.body(body).name);
      if (std::ranges::find(names, name) == names.end()) {
        names.push_back(name);
      }
    }
  }
  if (!names.empty() && one.which.is_gear) {
    found.warning(
        "W0506",
        one.which.where,
        fmt::format("gear '{}' leaves the speed of {} open, which neither its input nor its output "
                    "feels",
                    one.which.label,
                    plain_list(names)),
        "what moves with it has no value; hold it by an element or a coupling if it should have");
  } else if (!names.empty()) {
    found.warning(
        "W0506",
        one.which.where,
        fmt::format("case '{}' gives no rate for an idle freedom of {}: a turn or slide that moves "
                    "no other body",
                    one.which.label,
                    plain_list(names)),
        "'kinestat mobility' lists these freedoms; give the case the rate of one, or hold "
        "it by a coupling");
  }
}

// What a torque converter would have to take, where the torques of a case decide its slip.
std::string converter_text(const JudgedFile& file, const CaseAnalysis& one) {
  if (!one.converter_search) {
    return "";
  }
  const ConverterSearch& search = *one.converter_search;
  const KnownSide side = action_side(file, one.which);
  const auto in_unit = [&](double si) {
    return fmt::format(
        "{:.6g} {}", si / side.unit(search.action), side.units.text(side.kind(search.action)));
  };
  const std::string& converter = file.mechanism.topology.coupling(search.coupling).name;
  if (!search.ratios.empty()) {
    return fmt::format("; torque converter '{}' takes '{}' at speed ratios of {:.6g} and {:.6g}",
                       converter,
                       side.name(search.action),
                       search.ratios.front(),
                       search.ratios.back());
  }
  return fmt::format(
      "; torque converter '{}' takes '{}' at no speed ratio: it ranges from {} to {} there",
      converter,
      side.name(search.action),
      in_unit(search.least),
      in_unit(search.greatest));
}

void add_motion_findings(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found) {
  const KinematicSolution& motion = *one.motion;
  const KnownSide side = motion_side(file, one.which);
  const std::string given =
      motion.check.missing > 0 ? completions_text(motion.check, side) : std::string();
  add_idle_findings(file, one, found);
  if (motion.status == SolveStatus::dependent && motion.check.dependences.empty()) {
    found.error("E0502",
                one.which.where,
                fmt::format("case '{}' gives motions that depend on each other", one.which.label),
                "the mechanism closes by least squares alone, which does not tell how; give no "
                "more motions than it has drives");
  } else if (motion.status == SolveStatus::underdetermined && motion.check.undetermined.empty()) {
    found.error("E0501",
                one.which.where,
                fmt::format("case '{}' does not determine the motion", one.which.label),
                "the mechanism closes by least squares alone; give the motions of its drives");
  } else if (motion.status == SolveStatus::dependent) {
    found.error("E0502",
                place_of_surplus(one.which.motions, motion.check, one.which.where),
                fmt::format("case '{}' gives motions that depend on each other: {}",
                            one.which.label,
                            circuits_text(file, motion, side)),
                removal_text(motion.check, side) + (given.empty() ? "" : ", and " + given));
  } else if (motion.status == SolveStatus::overflow) {
    found.error("E0503",
                one.which.where,
                fmt::format("case '{}': velocities are too large to compute with", one.which.label),
                "give smaller motions; the answer is proportional to them");
  } else if (motion.status == SolveStatus::underdetermined) {
    found.error(
        "E0501",
        one.which.where,
        fmt::format("case '{}' gives {} of the {} motions needed (net degree of freedom "
                    "{}); not determined: {}{}",
                    one.which.label,
                    one.which.motions.empty() ? "none" : std::to_string(one.which.motions.size()),
                    motion.counts.net_freedom,
                    motion.counts.net_freedom,
                    plain_list(names_of(motion.check.undetermined, side)),
                    converter_text(file, one)),
        given + (given.empty() ? "" : "; or ") + "a coupling is missing, or joins other bodies");
  }
}

// At the coupling of the output.
void add_locking(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found) {
  const Topology& topology = file.mechanism.topology;
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

void add_second_answer(const CaseAnalysis& one, CaseFindings& found) {
  const TransmissionEfficiency& efficiency = *one.efficiency;
  for (const auto* way : {&efficiency.carrier, &efficiency.carrier_backward}) {
    if (way->other) {
      found.warning(
          "W0703",
          one.which.where,
          fmt::format("case '{}'{} has two efficiencies with its mesh losses, {:.6g} and {:.6g}",
                      one.which.label,
                      way == &efficiency.carrier ? "" : ", driven by the output,",
                      *way->value,
                      *way->other),
          "either may hold, and how the train was started decides; losses of some hundredths have "
          "one answer");
    }
  }
}

// No motion moves the axes to another body.
void add_missing_carriers(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found) {
  for (const CouplingId mesh : one.efficiency->without_carrier) {
    const CouplingTopology& coupling = file.mechanism.topology.coupling(mesh);
    found.warning("W0701",
                  coupling.where,
                  fmt::format("the loss of mesh '{}' is not known, since no one body holds the "
                              "axes of its gears",
                              coupling.name),
                  "join each of them to its carrier by a coupling of type revolute, or take the "
                  "mesh out of 'losses'");
  }
}

void add_power_findings(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found) {
  const bool is_locked_anyway = one.power && one.power->is_self_locking;
  if (is_locked_anyway) {
    found.warning("W0602",
                  one.which.where,
                  fmt::format("case '{}' is self-locking: friction absorbs more power than the "
                              "input supplies, so the output must drive too",
                              one.which.label),
                  "the input alone cannot move it in this direction; this may be intended");
  }
  if (one.efficiency && one.efficiency->carrier.is_self_locking && !is_locked_anyway) {
    add_locking(file, one, found);
  }
  if (one.power && !one.power->is_balanced) {
    CaseFinding& added = found.error(
        "E0701",
        one.which.where,
        fmt::format("case '{}': the powers sum to {:.3g} of the largest instead of zero",
                    one.which.label,
                    one.power->balance_residual),
        "the position is close to singular, or the scales are too far apart");
    added.size = one.power->balance_residual;
  }
  if (one.efficiency) {
    add_second_answer(one, found);
    add_missing_carriers(file, one, found);
  }
}

}  // namespace

CaseFinding& CaseFindings::error(std::string_view code,
                                 SourceRange where,
                                 std::string message,
                                 std::string hint) {
  return items_.emplace_back(CaseFinding{.severity = Severity::error,
                                         .code = code,
                                         .where = where,
                                         .message = std::move(message),
                                         .hint = std::move(hint)});
}

CaseFinding& CaseFindings::warning(std::string_view code,
                                   SourceRange where,
                                   std::string message,
                                   std::string hint) {
  return items_.emplace_back(CaseFinding{.severity = Severity::warning,
                                         .code = code,
                                         .where = where,
                                         .message = std::move(message),
                                         .hint = std::move(hint)});
}

JudgedFile judged_file(const Analysis& analysis) {
  return {.description = analysis.description,
          .mechanism = analysis.mechanism,
          .shift = analysis.shift};
}

CaseFindings find_case_findings(const JudgedFile& file,
                                const CaseAnalysis& one,
                                IsReported is_reported) {
  CaseFindings found(std::move(is_reported));
  if (one.motion) {
    add_motion_findings(file, one, found);
  }
  add_load_findings(file, one, found);
  if (one.action && !is_open_gear(file, one)) {
    add_action_status_findings(file, one, found);
  }
  if (one.action) {
    add_action_value_findings(file, one, found);
    add_tooth_findings(file, one, found);
  }
  add_freewheel_findings(file, one, found);
  add_clutch_findings(file, one, found);
  add_power_findings(file, one, found);
  if (const ShiftState* state = find_state(file, one)) {
    add_limit_findings(file, one, *state, found);
  }
  return found;
}

void add(const CaseFinding& one, Diagnostics& found) {
  if (one.severity == Severity::error) {
    found.error(one.code, one.where, one.message, one.hint);
  } else {
    found.warning(one.code, one.where, one.message, one.hint);
  }
}

namespace {

// What is wrong with a mesh is so in every case.
bool is_reported(const CaseFinding& one, const Diagnostics& found) {
  return std::ranges::any_of(found.items(), [&](const Diagnostic& other) {
    return other.code == one.code && other.where == one.where && other.message == one.message;
  });
}

// A motion answers where its case moves, and may be drawn where that rests.
CaseFinding told_of_drawing(CaseFinding one, const Case& which, const Analysis& analysis) {
  const std::optional<MotionDescription>& motion = analysis.description.motion;
  const bool is_of_motion = motion && motion->label && motion->label->text == which.label;
  if (one.code == "E0606" && is_of_motion) {
    one.severity = Severity::warning;
    one.code = "W0508";
    one.message += " in the drawn position";
    one.hint =
        "the motion has actions wherever this coupling moves; to have them here too, draw a "
        "position in which it does";
  }
  return one;
}

}  // namespace

void add_slip_findings(const ShiftAnalysis& shift, Diagnostics& found) {
  for (const SlipObstacle& one : shift.slips_without_answer) {
    found.error("E0712",
                one.where,
                fmt::format("slip '{}' has no answer: {}", one.name, one.reason),
                one.remedy);
  }
}

void add_findings(const Analysis& analysis, Diagnostics& found) {
  for (const CaseAnalysis& one : analysis.cases) {
    const CaseFindings of_case = find_case_findings(judged_file(analysis), one);
    for (const CaseFinding& finding : of_case.items()) {
      const CaseFinding told = told_of_drawing(finding, one.which, analysis);
      if (!is_reported(told, found)) {
        add(told, found);
      }
    }
  }
  if (analysis.shift) {
    add_slip_findings(*analysis.shift, found);
  }
}

}  // namespace kinestat
