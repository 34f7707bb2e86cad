#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "cases/findings/action_findings.hpp"
#include "core/text.hpp"
#include "statics/one_sided_action.hpp"

namespace kinestat {

namespace {

// "belt_1.F = 12 N and belt_2.F = 12 N", what the pretension adds to the segments.
std::string pretension_text(const JudgedFile& file, const VecX& pretension) {
  const Topology& topology = file.mechanism.topology;
  const FileUnits& units = file.description.units;
  std::vector<std::string> names;
  for (const CouplingTopology& coupling : topology.couplings) {
    const double force =
        coupling.type == CouplingType::cable ? pretension[coupling.first_action] : 0.0;
    if (force > 0.0) {
      names.push_back(fmt::format("{} {:.6g} {}",
                                  topology.action_name(coupling.first_action),
                                  units.from_si(QuantityKind::force, force),
                                  units.text(QuantityKind::force)));
    }
  }
  return plain_list(names);
}

void add_pushed_segments(const JudgedFile& file,
                         const CaseAnalysis& one,
                         const std::vector<CouplingId>& pushed,
                         CaseFindings& found) {
  const Topology& topology = file.mechanism.topology;
  const FileUnits& units = file.description.units;
  const std::string hint =
      one.pretension
          ? fmt::format("a pretension keeps the cables in tension: add at least {}",
                        pretension_text(file, *one.pretension))
          : "a cable only pulls, and no pretension can tighten this one: raise a known action, "
            "reverse the load or the motion, or hold the cable by another actuator";
  for (const CouplingId id : pushed) {
    const CouplingTopology& segment = topology.coupling(id);
    const double force =
        one.action->magnitudes[static_cast<std::size_t>(segment.first_action)].value_or(0.0);
    CaseFinding& added =
        found.warning("W0606",
                      segment.where,
                      fmt::format("case '{}': segment '{}' would be in compression with {:.6g} {}",
                                  one.which.label,
                                  segment.name,
                                  units.from_si(QuantityKind::force, -force),
                                  units.text(QuantityKind::force)),
                      hint);
    added.element = segment.name;
    added.size = -force;
  }
}

// A contact with a slack side slips for want of tension, which that side's finding says.
void add_slipping_cables(const JudgedFile& file,
                         const CaseAnalysis& one,
                         const std::vector<CouplingId>& pushed,
                         CaseFindings& found) {
  for (std::size_t i = 0; i < one.contacts.size(); ++i) {
    const CableContactState& state = one.contacts[i];
    const CableContact& contact = file.mechanism.contacts[i];
    const auto is_slack = [&](CouplingId side) {
      return std::ranges::find(pushed, side) != pushed.end();
    };
    if (state.belt_state != BeltState::beyond_limit || is_slack(contact.arrives) ||
        is_slack(contact.leaves)) {
      continue;
    }
    CaseFinding& added = found.warning(
        "W0607",
        contact.where,
        fmt::format(
            "case '{}': the cable would slip in '{}': friction holds tensions of a ratio of "
            "up to {:.6g}, and this is {}",
            one.which.label,
            contact.name,
            *state.limit,
            state.ratio ? fmt::format("{:.6g}", *state.ratio) : "more than any ratio"),
        contact.slips
            ? "more pretension, a larger contact angle or more friction hold it; or give the "
              "virtual link a motion, with which it slips"
            : "more pretension, a larger contact angle or more friction hold it; or let it slip: "
              "'slip: true', and a motion of the virtual link");
    added.element = contact.name;
    added.size = state.ratio.value_or(std::numeric_limits<double>::infinity());
  }
}

// Of pulleys that stand still, and of cables that do not slip where they may: the couple by which
// an actuator holds a cable is an action, but 'eta' is left out.
void add_held_cables(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found) {
  if (one.motion && one.motion->status != SolveStatus::solved) {
    return;  // why it has no answer is said of the motion
  }
  std::vector<std::string> held;
  std::vector<std::string> gripped;
  for (const CouplingId coupling : one.action->held_cables) {
    const std::string& name = file.mechanism.topology.coupling(coupling).name;
    const auto contact =
        std::ranges::find(file.mechanism.contacts, std::optional(coupling), &CableContact::slips);
    if (contact == file.mechanism.contacts.end()) {
      held.push_back(name);
    } else if (contact->efficiency < 1.0 && !contact->turns) {
      gripped.push_back(name);
    }
  }
  const auto warn = [&](const std::string& of, std::string hint) {
    found.warning("W0609",
                  one.which.where,
                  fmt::format("case '{}': {}, so 'eta' has no direction: actions are those without "
                              "its loss",
                              one.which.label,
                              of),
                  std::move(hint));
  };
  if (!gripped.empty()) {
    warn(
        fmt::format("{} on {}",
                    one.motion ? "the cable does not slip" : "nothing says whether the cable slips",
                    quoted_list(gripped)),
        "let the pulley turn on a revolute coupling at its centre, or the cable slip by a very "
        "small "
        "speed in the direction of the coming motion");
  }
  if (!held.empty()) {
    warn(fmt::format("the drum or pulley on {} {}",
                     quoted_list(held),
                     one.motion ? "is at rest" : "has no known motion"),
         "for a start from rest give its drive a very small speed in the direction of the coming "
         "motion, 1e-3 rpm for example");
  }
}

}  // namespace

void add_cable_findings(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found) {
  const std::vector<CouplingId> pushed = find_pushed_segments(file.mechanism, *one.action);
  add_pushed_segments(file, one, pushed, found);
  add_slipping_cables(file, one, pushed, found);
  add_held_cables(file, one, found);
}

}  // namespace kinestat
