#include "run/findings.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/tolerance.hpp"
#include "screw/screw_axis.hpp"

namespace kinestat {

namespace {

// How the magnitudes of one side are shown: names as the file gives them, in the units of the file.
struct Side {
  std::function<std::string(int)> name;
  std::function<double(int)> unit;           ///< SI per unit of the file
  std::string_view key;                      ///< "motion" or "action"
  std::function<std::string(int)> actuator;  ///< that moves or bears it; empty if none does
};

std::vector<std::string> names_of(const std::vector<int>& indices, const Side& side) {
  std::vector<std::string> names;
  for (const int i : indices) {
    names.push_back(side.name(i));
  }
  return names;
}

// "add to 'motion:' for example drive or b.wz", or sets in braces where several are missing; those
// of actuators first, which are what an engineer would give.
std::string completions_text(const PrimaryCheck& check, const Side& side) {
  std::vector<std::string> sets;
  std::vector<std::string> others;
  for (const std::vector<int>& set : check.completions) {
    std::vector<std::string> names;
    bool has_actuators = true;
    for (const int i : set) {
      const std::string actuator = side.actuator(i);
      names.push_back(actuator.empty() ? side.name(i) : actuator);
      has_actuators = has_actuators && !actuator.empty();
    }
    const std::string listed = plain_list(names);
    (has_actuators ? sets : others).push_back(set.size() == 1 ? listed : "{" + listed + "}");
  }
  sets.insert(sets.end(), others.begin(), others.end());
  if (sets.empty()) {
    return {};
  }
  return fmt::format("add to '{}:' {}{}",
                     side.key,
                     sets.size() == 1 ? "" : "for example ",
                     fmt::join(sets, " or "));
}

// "a.wz = 2.5 b.wz - c.wz", or "a.wz = 0", as numbers in the units of the file.
std::string relation_text(const std::vector<DependenceTerm>& terms, const Side& side) {
  const auto size = [&](const DependenceTerm& term) {
    return term.coefficient * side.unit(term.index);
  };
  std::string text;
  for (const DependenceTerm& term : std::span(terms).subspan(1)) {
    const double share = -size(term) / size(terms.front());
    const bool is_one = std::abs(std::abs(share) - 1.0) <= kRankZero;
    text += text.empty() ? (share < 0 ? "-" : "") : (share < 0 ? " - " : " + ");
    text += is_one ? "" : fmt::format("{:.6g} ", std::abs(share));
    text += side.name(term.index);
  }
  return fmt::format("{} = {}", side.name(terms.front().index), text.empty() ? "0" : text);
}

std::string relations_text(const PrimaryCheck& check, const Side& side) {
  std::vector<std::string> relations;
  for (const auto& terms : check.dependences) {
    relations.push_back(relation_text(terms, side));
  }
  return fmt::format("{}", fmt::join(relations, " and "));
}

// "remove 'a' or 'b' from 'motion:'": any one that takes part in the first relation.
std::string removal_text(const PrimaryCheck& check, const Side& side) {
  std::vector<std::string> names;
  for (const DependenceTerm& term : check.dependences.front()) {
    names.push_back(fmt::format("'{}'", side.name(term.index)));
  }
  return fmt::format("remove {} from '{}:'", fmt::join(names, " or "), side.key);
}

SourceRange place_of_surplus(const std::vector<Primary>& primaries,
                             const PrimaryCheck& check,
                             SourceRange otherwise) {
  const auto at =
      std::ranges::find(primaries, check.dependences.front().front().index, &Primary::index);
  return at == primaries.end() ? otherwise : at->where;
}

// The name that the case itself uses for a magnitude, or another.
std::string name_in(const std::vector<Primary>& primaries, int index, std::string otherwise) {
  const auto at = std::ranges::find(primaries, index, &Primary::index);
  return at == primaries.end() ? otherwise : at->given;
}

// The first actuator on a freedom or of an action.
std::string actuator_of(const Topology& topology, int ActuatorTopology::*member, int index) {
  const auto at = std::ranges::find(topology.actuators, index, member);
  return at == topology.actuators.end() ? std::string() : at->name;
}

Side motion_side(const Analysis& analysis, const Case& which) {
  const Topology& topology = analysis.mechanism.topology;
  const FileUnits& units = analysis.description.units;
  return {.name = [&](int i) { return name_in(which.motions, i, topology.freedom_name(i)); },
          .unit =
              [&](int i) {
                return units.factor(topology.freedoms[static_cast<std::size_t>(i)].is_rotation
                                        ? QuantityKind::angular_velocity
                                        : QuantityKind::velocity);
              },
          .key = "motion",
          .actuator = [&](int i) { return actuator_of(topology, &ActuatorTopology::freedom, i); }};
}

Side action_side(const Analysis& analysis, const Case& which) {
  const Topology& topology = analysis.mechanism.topology;
  const FileUnits& units = analysis.description.units;
  return {.name = [&](int i) { return name_in(which.actions, i, topology.action_name(i)); },
          .unit =
              [&](int i) {
                return units.factor(topology.actions[static_cast<std::size_t>(i)].is_couple
                                        ? QuantityKind::moment
                                        : QuantityKind::force);
              },
          .key = "action",
          .actuator = [&](int i) { return actuator_of(topology, &ActuatorTopology::action, i); }};
}

void add_motion_findings(const Analysis& analysis, const CaseAnalysis& one, Diagnostics& found) {
  const KinematicSolution& motion = *one.motion;
  const Side side = motion_side(analysis, one.which);
  if (motion.status == SolveStatus::dependent) {
    found.error("E0502",
                place_of_surplus(one.which.motions, motion.check, one.which.where),
                fmt::format("case '{}' gives motions that depend on each other: the couplings "
                            "demand {}",
                            one.which.label,
                            relations_text(motion.check, side)),
                removal_text(motion.check, side) +
                    (motion.check.missing > 0
                         ? fmt::format(", and {}", completions_text(motion.check, side))
                         : ""));
  } else if (motion.status == SolveStatus::overflow) {
    found.error("E0503",
                one.which.where,
                fmt::format("case '{}': velocities are too large for a number", one.which.label),
                "give smaller motions; the answer is proportional to them");
  } else if (motion.status == SolveStatus::underdetermined) {
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

// "body 'planet5' can turn about the axis (0, 0, 1) through (0, 17, 0)", lengths in file units.
std::string unheld_text(const Analysis& analysis, const UnheldMotion& unheld) {
  const auto axis = find_axis(unheld.twist, analysis.mechanism.geometry.length);
  const std::string body = analysis.mechanism.topology.body(unheld.body).name;
  const bool is_planar = analysis.mechanism.space == Space::planar;
  const auto list = [&](const Vec3& v) {
    const auto tidy = [](double x) { return std::abs(x) <= kRankZero ? 0.0 : x; };
    const std::string first = fmt::format("({:.6g}, {:.6g}", tidy(v.x()), tidy(v.y()));
    return first + (is_planar ? ")" : fmt::format(", {:.6g})", tidy(v.z())));
  };
  if (!axis) {
    return fmt::format("body '{}' can move", body);
  }
  if (!axis->point) {
    return fmt::format("body '{}' can slide along {}", body, list(axis->direction));
  }
  const FileUnits& units = analysis.description.units;
  const Vec3 point =
      (*axis->point + analysis.mechanism.geometry.origin) / units.factor(QuantityKind::length);
  const std::string& unit = units.text(QuantityKind::length);
  return is_planar
             ? fmt::format("body '{}' can turn about the point {} {}", body, list(point), unit)
             : fmt::format("body '{}' can turn about the axis {} through {} {}",
                           body,
                           list(axis->direction),
                           list(point),
                           unit);
}

void add_action_findings(const Analysis& analysis, const CaseAnalysis& one, Diagnostics& found) {
  const StaticSolution& action = *one.action;
  const Side side = action_side(analysis, one.which);
  if (action.status == SolveStatus::inconsistent) {
    found.error(
        "E0602",
        place_of_surplus(one.which.actions, action.check, one.which.where),
        fmt::format("case '{}' has no equilibrium, which demands {}{}{}",
                    one.which.label,
                    relations_text(action.check, side),
                    action.unheld ? "; nothing holds the load: " : "",
                    action.unheld ? unheld_text(analysis, *action.unheld) : ""),
        removal_text(action.check, side) + " so that it is solved, or add what holds this motion");
  } else if (action.status == SolveStatus::dependent) {
    found.error("E0601",
                place_of_surplus(one.which.actions, action.check, one.which.where),
                fmt::format("case '{}' gives actions that depend on each other: equilibrium "
                            "demands {}",
                            one.which.label,
                            relations_text(action.check, side)),
                removal_text(action.check, side));
  } else if (action.status == SolveStatus::overflow) {
    found.error("E0603",
                one.which.where,
                fmt::format("case '{}': actions are too large for a number", one.which.label),
                "give smaller actions; the answer is proportional to them");
  } else if (action.status == SolveStatus::underdetermined) {
    found.warning("W0601",
                  one.which.where,
                  fmt::format("case '{}' knows {} of the {} actions needed; equilibrium does not "
                              "determine {}",
                              one.which.label,
                              one.which.actions.size(),
                              action.counts.net_constraint,
                              plain_list(names_of(action.check.undetermined, side))),
                  completions_text(action.check, side));
  }
}

}  // namespace

void add_findings(const Analysis& analysis, Diagnostics& found) {
  for (const CaseAnalysis& one : analysis.cases) {
    if (one.motion) {
      add_motion_findings(analysis, one, found);
    }
    if (one.action) {
      add_action_findings(analysis, one, found);
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
}

}  // namespace kinestat
