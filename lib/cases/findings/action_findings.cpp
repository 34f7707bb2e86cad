#include "cases/findings/action_findings.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "cases/findings/bearing_pair.hpp"
#include "cases/findings/known_side.hpp"
#include "core/text.hpp"
#include "kinematics/bounded_motion.hpp"
#include "screw/bounded_screw.hpp"
#include "statics/one_sided_action.hpp"

namespace kinestat {

namespace {

// "body 'planet5' can turn about the axis (0, 0, 1) through (0, 17, 0) mm", lengths in file units.
std::string unconstrained_text(const JudgedFile& file, const UnconstrainedMotion& unconstrained) {
  const auto axis = find_axis(written(unconstrained.twist), file.mechanism.geometry.length);
  const std::string body = file.mechanism.topology.body(unconstrained.body).name;
  const bool is_planar = file.mechanism.space == Space::planar;
  const auto list = [&](const Vec3& v) {
    const Vec3 unsigned_zeros = v + Vec3::Zero();
    const std::string first =
        fmt::format("({:.6g}, {:.6g}", unsigned_zeros.x(), unsigned_zeros.y());
    return first + (is_planar ? ")" : fmt::format(", {:.6g})", unsigned_zeros.z()));
  };
  if (!axis) {
    return fmt::format("body '{}' can move", body);
  }
  if (!axis->point) {
    return fmt::format("body '{}' can slide along {}", body, list(axis->direction));
  }
  const FileUnits& units = file.description.units;
  const double metre = units.factor(QuantityKind::length);
  const Vec3 point = file.mechanism.geometry.origin.in_world(*axis->point) / metre;
  const std::string& unit = units.text(QuantityKind::length);
  if (is_planar) {
    return fmt::format("body '{}' can turn about the point {} {}", body, list(point), unit);
  }
  const bool is_screw = *axis->pitch != 0.0;
  return fmt::format(
      "body '{}' can turn about the axis {} through {} {}{}",
      body,
      list(axis->direction),
      list(point),
      unit,
      is_screw ? fmt::format(", sliding {:.6g} {}/rad along it", *axis->pitch / metre, unit) : "");
}

// "load 'wind'", or "loads 'wind', 'gravity.arm'".
std::string loads_text(const std::vector<Load>& loads, const std::vector<int>& working) {
  std::vector<std::string> names;
  for (const int i : working) {
    names.push_back(fmt::format("'{}'", loads[static_cast<std::size_t>(i)].name));
  }
  return fmt::format("load{} {}", names.size() == 1 ? "" : "s", plain_list(names));
}

// Loads act on a motion that nothing resists, whatever the primaries are.
void add_unbalanced_loads(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found) {
  const std::optional<UnconstrainedMotion>& unconstrained = one.action->unconstrained;
  const bool is_named = unconstrained && !unconstrained->loads.empty();
  const auto& loads = one.which.loads;
  const std::string nameless =
      file.mechanism.frictions.empty() ? "the loads" : "what friction causes";
  found.error("E0602",
              is_named ? loads[static_cast<std::size_t>(unconstrained->loads.front())].where
                       : one.which.where,
              fmt::format("case '{}' has no equilibrium: nothing balances {}{}",
                          one.which.label,
                          is_named ? loads_text(loads, unconstrained->loads) : nameless,
                          unconstrained ? ": " + unconstrained_text(file, *unconstrained) : ""),
              "add an actuator or a coupling that resists this motion, or remove the load");
}

void add_contradiction(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found) {
  const StaticSolution& action = *one.action;
  if (action.check.dependences.empty()) {
    add_unbalanced_loads(file, one, found);
    return;
  }
  const KnownSide side = action_side(file, one.which);
  const bool has_friction = !file.mechanism.frictions.empty();
  found.error(
      "E0602",
      place_of_surplus(one.which.actions, action.check, one.which.where),
      fmt::format("case '{}' has no equilibrium: {}{}{}{}",
                  one.which.label,
                  has_friction ? "without friction, " : "",
                  cutsets_text(file, action, side),
                  !action.unconstrained     ? ""
                  : has_friction            ? "; without it nothing resists the motion: "
                  : one.which.loads.empty() ? "; nothing resists the motion: "
                                            : "; nothing balances the load: ",
                  action.unconstrained ? unconstrained_text(file, *action.unconstrained) : ""),
      removal_text(action.check, side) + " so that it is solved" +
          (has_friction ? " with friction" : "") +
          ", or add a support or actuator that resists this motion");
}

// "work = -3305.72 N": what an equilibrium demands of the actuators that the case does not know, or
// of the first action, if there are none.
std::string demands_text(const JudgedFile& file, const CaseAnalysis& one, const VecX& actions) {
  const KnownSide side = action_side(file, one.which);
  const auto is_known = [&](int a) {
    return std::ranges::find(one.which.actions, a, &Primary::index) != one.which.actions.end();
  };
  const auto is_open = [&](int a) {
    return one.action->status == SolveStatus::underdetermined &&
           std::ranges::find(one.action->check.undetermined, a) !=
               one.action->check.undetermined.end();
  };
  std::vector<int> shown;
  for (const int a : file.mechanism.topology.driving_actions()) {
    if (!is_known(a) && !is_open(a)) {
      shown.push_back(a);
    }
  }
  for (int a = 0; shown.empty() && a < actions.size(); ++a) {
    if (!is_known(a) && !is_open(a)) {
      shown.push_back(a);
    }
  }
  std::vector<std::string> parts;
  for (const int a : shown) {
    parts.push_back(fmt::format(
        "{} = {:.6g} {}", side.name(a), actions[a] / side.unit(a), side.units.text(side.kind(a))));
  }
  return plain_list(parts);
}

// Without friction nothing balances a known action; with it, actions of either sign may.
void add_held_by_friction(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found) {
  const StaticSolution& action = *one.action;
  std::string equilibria = demands_text(file, one, action.other_actions.front());
  for (std::size_t i = 1; i < action.other_actions.size(); ++i) {
    equilibria += ", or " + demands_text(file, one, action.other_actions[i]);
  }
  found.error(
      "E0605",
      place_of_surplus(one.which.actions, action.check, one.which.where),
      fmt::format("case '{}': friction alone holds the known actions and does not determine the "
                  "contact side: {}",
                  one.which.label,
                  equilibria),
      removal_text(action.check, action_side(file, one.which)) + " and give one of these instead");
}

void add_other_equilibrium(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found) {
  if (one.action->magnitudes.empty() || one.action->other_actions.empty()) {
    return;
  }
  found.warning("W0608",
                one.which.where,
                fmt::format("case '{}' has another equilibrium with this friction: {}",
                            one.which.label,
                            demands_text(file, one, one.action->other_actions.front())),
                "the result is the one reached as friction grows from zero; to get the other, give "
                "one of its actions instead of a known one");
}

std::string names_of(const std::vector<CouplingId>& couplings, const Topology& topology) {
  std::vector<std::string> names;
  for (const CouplingId id : couplings) {
    names.push_back(fmt::format("'{}'", topology.coupling(id).name));
  }
  return plain_list(names);
}

// Whether a coupling is a slipping cable on its pulley.
bool is_slip_of_cable(CouplingId coupling, const Mechanism& mechanism) {
  return std::ranges::any_of(
      mechanism.contacts, [&](const CableContact& contact) { return contact.slips == coupling; });
}

// A torque converter whose characteristic says nothing of the speeds of the case.
const CouplingFriction* find_converter_without_value(const JudgedFile& file,
                                                     const CaseAnalysis& one) {
  const auto found =
      std::ranges::find_if(file.mechanism.frictions, [&](const CouplingFriction& friction) {
        if (!friction.converter) {
          return false;
        }
        const auto [pump, turbine] = converter_turns(file.mechanism, *one.motion, friction);
        return !friction.converter->point(pump, turbine);
      });
  return found == file.mechanism.frictions.end() ? nullptr : &*found;
}

void add_converter_without_value(const JudgedFile& file,
                                 const CaseAnalysis& one,
                                 const CouplingFriction& friction,
                                 CaseFindings& found) {
  const auto [pump, turbine] = converter_turns(file.mechanism, *one.motion, friction);
  const Topology& topology = file.mechanism.topology;
  const std::string speeds = pump == 0.0
                                 ? fmt::format("its pump '{}' rests and its turbine '{}' turns",
                                               topology.body(friction.converter->pump).name,
                                               topology.body(friction.converter->turbine).name)
                                 : fmt::format("its speed ratio is {:.6g}", turbine / pump);
  found.error("E0604",
              friction.where,
              fmt::format("case '{}': the characteristic of torque converter '{}' has no value, or "
                          "generates power, where {}",
                          one.which.label,
                          topology.coupling(friction.coupling).name,
                          speeds),
              "extend its tables to that speed ratio, or give speeds between stall, 0, and 1");
}

// A drag for whose speed the expression of the file has no value.
const CouplingFriction* find_drag_without_value(const JudgedFile& file, const CaseAnalysis& one) {
  const Topology& topology = file.mechanism.topology;
  const auto found =
      std::ranges::find_if(file.mechanism.frictions, [&](const CouplingFriction& friction) {
        const int freedom = topology.coupling(friction.coupling).first_freedom;
        return friction.tau_of_speed &&
               !tau_at(friction, std::abs(bounded_rate(*one.motion, freedom).zeroed()));
      });
  return found == file.mechanism.frictions.end() ? nullptr : &*found;
}

// Of a case that holds everything still: how it begins to move.
std::string start_hint(const KnownSide& side, const Case& which) {
  const bool rests =
      std::ranges::all_of(which.motions, [](const Primary& one) { return one.value == 0.0; });
  if (which.motions.empty() || !rests) {
    return {};
  }
  const int first = which.motions.front().index;
  return fmt::format(
      "; for a start from rest give a very small speed in the direction of the coming motion, "
      "motion: {{{}: 1e-3 {}}}",
      side.name(first),
      side.units.text(side.kind(first)));
}

void add_friction_at_rest(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found) {
  const bool has_motion = one.motion.has_value();
  if (has_motion && one.motion->status != SolveStatus::solved) {
    return;  // why it has no answer is said of the motion
  }
  if (const CouplingFriction* converter =
          has_motion ? find_converter_without_value(file, one) : nullptr) {
    add_converter_without_value(file, one, *converter, found);
    return;
  }
  if (const CouplingFriction* drag = has_motion ? find_drag_without_value(file, one) : nullptr) {
    const CouplingTopology& coupling = file.mechanism.topology.coupling(drag->coupling);
    found.error(
        "E0604",
        drag->where,
        fmt::format("case '{}': 'tau' of the friction of '{}' has no value, or a negative one, at "
                    "{:.6g} rad/s",
                    one.which.label,
                    coupling.name,
                    std::abs(one.motion->rates[static_cast<std::size_t>(coupling.first_freedom)])),
        "write an expression that is not negative at any speed, for example with max(0 N*m, …)");
    return;
  }
  const std::string names = names_of(one.action->at_rest, file.mechanism.topology);
  if (!has_motion) {
    found.error("E0604",
                one.which.where,
                fmt::format("case '{}': friction of {} has no direction: the case gives no motion",
                            one.which.label,
                            names),
                "add 'motion:' to the case; its direction counts, and its magnitude where there is "
                "viscous friction");
    return;
  }
  const auto turns_freely = [&](CouplingId id) {
    return !one.motion->knows_rate(file.mechanism.topology.coupling(id).first_freedom);
  };
  if (std::ranges::all_of(one.action->at_rest, turns_freely)) {
    found.error("E0606",
                one.which.where,
                fmt::format("case '{}': friction of {} has no direction: the gear leaves its speed "
                            "open",
                            one.which.label,
                            names),
                "what rubs there decides how fast it turns: hold it by an element of the gear, or "
                "remove its friction");
    return;
  }
  const bool holds_cables = std::ranges::all_of(
      one.action->at_rest, [&](CouplingId id) { return is_slip_of_cable(id, file.mechanism); });
  found.error("E0606",
              one.which.where,
              fmt::format("case '{}': friction of {} has no direction: nothing moves there",
                          one.which.label,
                          names),
              fmt::format("friction at rest may have any magnitude up to its limit: {}{}",
                          holds_cables
                              ? "declare an actuator on this coupling, which then holds the cable, "
                                "or let the cable slip"
                              : "draw a position, or give a motion, in which this coupling moves, "
                                "or remove its friction",
                          start_hint(motion_side(file, one.which), one.which)));
}

// What has no value, neither from equilibrium nor from what completes it.
std::vector<int> find_open(const StaticSolution& action) {
  std::vector<int> open;
  std::ranges::copy_if(action.check.undetermined, std::back_inserter(open), [&](int a) {
    return !is_completed(action, a);
  });
  return open;
}

// What to type where the known actions are too few: more of them, or what completes them.
std::string ways_out(const JudgedFile& file,
                     const StaticSolution& action,
                     const std::vector<int>& open,
                     const KnownSide& side) {
  const std::string release = bearing_pair_hint(file.mechanism, open);
  const std::string given = completions_text(action.check, side);
  const std::string more = release + (release.empty() || given.empty() ? "" : "; or ") + given;
  if (!action.open_friction.empty()) {
    return (release.empty() ? "let the couplings carry less: 'passive:' lists what one carries"
                            : release) +
           (given.empty() ? "" : "; or " + given);
  }
  if (file.mechanism.indeterminate == IndeterminateChoice::stiffness) {
    return "give a 'stiffness:' to those of them that are not rigid" +
           (more.empty() ? "" : "; or " + more);
  }
  return more + (more.empty() ? "" : "; or ") +
         "add 'statics: {indeterminate: minimum_norm}', or 'stiffness:' to couplings and "
         "'statics: {indeterminate: stiffness}'";
}

void add_indeterminacy(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found) {
  const StaticSolution& action = *one.action;
  const std::vector<int> open = find_open(action);
  if (open.empty()) {
    return;  // completed as the file asks for
  }
  if (found.is_reported("W0601", one.which.where)) {
    found.warning("W0601", one.which.where, {});
    return;
  }
  const KnownSide side = action_side(file, one.which);
  const bool has_completion = action.completion.by != IndeterminateChoice::report;
  const bool waits_for_friction = !action.open_friction.empty();
  found.warning(
      "W0601",
      one.which.where,
      fmt::format("case '{}' gives {} of the {} actions that must be known; {} {}{}",
                  one.which.label,
                  one.which.actions.empty() ? "none" : std::to_string(one.which.actions.size()),
                  action.counts.net_constraint,
                  has_completion ? "neither equilibrium nor stiffness determines"
                                 : "equilibrium does not determine",
                  plain_list(names_of(open, side)),
                  waits_for_friction
                      ? fmt::format(", on which the friction of {} depends",
                                    names_of(action.open_friction, file.mechanism.topology))
                      : ""),
      ways_out(file, action, open, side));
}

void add_ignored_reactions(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found) {
  const FileUnits& units = file.description.units;
  for (const IgnoredReaction& ignored : one.action->ignored) {
    const QuantityKind kind =
        ignored.reaction == Reaction::axial ? QuantityKind::force : QuantityKind::moment;
    const CouplingTopology& coupling = file.mechanism.topology.coupling(ignored.coupling);
    const ReactionWords words = words_of(ignored.reaction);
    CaseFinding& added =
        found.warning("W0604",
                      coupling.where,
                      fmt::format("case '{}': friction of '{}' ignores its {} of {:.6g} {}",
                                  one.which.label,
                                  coupling.name,
                                  words.what,
                                  ignored.size / units.factor(kind),
                                  units.text(kind)),
                      fmt::format("give its friction {}", words.key));
    added.element = words.what;
    added.size = ignored.size;
  }
}

// A contact of two surfaces can only push; positive is along its normal, from tail to head.
void add_pulling_contacts(const JudgedFile& file, const CaseAnalysis& one, CaseFindings& found) {
  const Topology& topology = file.mechanism.topology;
  const FileUnits& units = file.description.units;
  for (const int a : find_pulling_contacts(file.mechanism, *one.action)) {
    const auto action = static_cast<std::size_t>(a);
    const CouplingTopology& coupling = topology.coupling(topology.actions[action].coupling);
    const double pull = -one.action->magnitudes[action].value_or(0.0);
    CaseFinding& added = found.warning(
        "W0605",
        coupling.where,
        fmt::format("case '{}': the surfaces of '{}' would have to pull on each other "
                    "with {:.6g} {}",
                    one.which.label,
                    coupling.name,
                    pull / units.factor(QuantityKind::force),
                    units.text(QuantityKind::force)),
        "they separate; or reverse the normal: it points from the first of the bodies to the "
        "second");
    added.element = coupling.name;
    added.size = pull;
  }
}

}  // namespace

ReactionWords words_of(Reaction reaction) {
  switch (reaction) {
    case Reaction::axial:
      return {"axial force", "'thrust_radius', the mean radius of the collar that bears it"};
    case Reaction::tilting:
      return {"tilting moment", "'length', the bearing length of the journal or guide"};
    case Reaction::torsion:
      return {"torque about its axis",
              "'radius', that of the spline or key that keeps it from turning"};
  }
  return {};
}

void add_action_status_findings(const JudgedFile& file,
                                const CaseAnalysis& one,
                                CaseFindings& found) {
  const StaticSolution& action = *one.action;
  const KnownSide side = action_side(file, one.which);
  if (!action.other_actions.empty() && action.magnitudes.empty()) {
    add_held_by_friction(file, one, found);
  } else if (action.status == SolveStatus::inconsistent) {
    add_contradiction(file, one, found);
  } else if (action.status == SolveStatus::dependent) {
    found.error("E0601",
                place_of_surplus(one.which.actions, action.check, one.which.where),
                fmt::format("case '{}' gives actions that depend on each other{}: {}",
                            one.which.label,
                            one.which.loads.empty() ? "" : " and on the loads",
                            cutsets_text(file, action, side)),
                removal_text(action.check, side));
  } else if (action.status == SolveStatus::overflow) {
    found.error("E0603",
                one.which.where,
                fmt::format("case '{}': actions are too large to compute with", one.which.label),
                one.which.loads.empty()
                    ? "give smaller actions; the answer is proportional to them"
                    : "give smaller actions and loads; the answer is proportional to them");
  } else if (action.status == SolveStatus::at_rest) {
    add_friction_at_rest(file, one, found);
  } else if (action.status == SolveStatus::locked_by_friction) {
    found.warning(
        "W0603",
        one.which.where,
        fmt::format("case '{}' jams: friction grows faster than the actions that cause it",
                    one.which.label),
        "no drive force, however large, moves it in this direction; a smaller coefficient of "
        "friction, another direction of motion or known actions of another member have an answer");
  } else if (action.status == SolveStatus::underdetermined) {
    add_indeterminacy(file, one, found);
  }
}

void add_action_value_findings(const JudgedFile& file,
                               const CaseAnalysis& one,
                               CaseFindings& found) {
  add_ignored_reactions(file, one, found);
  add_other_equilibrium(file, one, found);
  add_pulling_contacts(file, one, found);
  add_cable_findings(file, one, found);
}

}  // namespace kinestat
