#include "run/findings.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/tolerance.hpp"
#include "screw/screw_axis.hpp"

namespace kinestat {

namespace {

using NameOf = std::function<std::string(int)>;

std::vector<std::string> names_of(const std::vector<int>& indices, const NameOf& name) {
  std::vector<std::string> names;
  for (const int i : indices) {
    names.push_back(name(i));
  }
  return names;
}

// "add one of: a.wz; b.wz", or sets in braces where several are missing.
std::string completions_text(const PrimaryCheck& check, const NameOf& name) {
  std::vector<std::string> sets;
  for (const std::vector<int>& set : check.completions) {
    const std::string names = plain_list(names_of(set, name));
    sets.push_back(set.size() == 1 ? names : "{" + names + "}");
  }
  if (sets.empty()) {
    return {};
  }
  return fmt::format("add {}{}",
                     sets.size() == 1 ? "" : "one of ",
                     fmt::join(sets, check.missing == 1 ? ", " : " or "));
}

// "a.wz - 2.5 b.wz = 0", scaled to a first coefficient of 1.
std::string relation_text(const std::vector<DependenceTerm>& terms, const NameOf& name) {
  std::string text;
  for (const DependenceTerm& term : terms) {
    const double share = term.coefficient / terms.front().coefficient;
    if (std::abs(share) <= kRankZero) {
      continue;
    }
    const std::string sign = text.empty() ? "" : (share < 0 ? " - " : " + ");
    const bool is_one = std::abs(std::abs(share) - 1.0) <= kRankZero;
    text += fmt::format(
        "{}{}{}", sign, is_one ? "" : fmt::format("{:.6g} ", std::abs(share)), name(term.index));
  }
  return text + " = 0";
}

std::string relations_text(const PrimaryCheck& check, const NameOf& name) {
  std::vector<std::string> relations;
  for (const auto& terms : check.dependences) {
    relations.push_back(relation_text(terms, name));
  }
  return fmt::format("{}", fmt::join(relations, " and "));
}

SourceRange place_of_surplus(const std::vector<Primary>& primaries,
                             const PrimaryCheck& check,
                             SourceRange otherwise) {
  const auto at =
      std::ranges::find(primaries, check.dependences.front().front().index, &Primary::index);
  return at == primaries.end() ? otherwise : at->where;
}

void add_motion_findings(const Topology& topology, const CaseAnalysis& one, Diagnostics& found) {
  const KinematicSolution& motion = *one.motion;
  const NameOf name = [&](int i) { return topology.freedom_name(i); };
  if (motion.status == SolveStatus::dependent) {
    const std::string more = motion.check.missing > 0
                                 ? fmt::format("give {} of these motions another place; {}",
                                               motion.check.dependences.size(),
                                               completions_text(motion.check, name))
                                 : "remove one of these motions";
    found.error("E0502",
                place_of_surplus(one.which.motions, motion.check, one.which.where),
                fmt::format("case '{}': the known motions depend on each other: the couplings "
                            "demand {}",
                            one.which.label,
                            relations_text(motion.check, name)),
                more);
  } else if (motion.status == SolveStatus::underdetermined) {
    found.error("E0501",
                one.which.where,
                fmt::format("case '{}' knows {} of the {} motions needed (net degree of freedom "
                            "{}); undetermined are {}",
                            one.which.label,
                            one.which.motions.size(),
                            motion.counts.net_freedom,
                            motion.counts.net_freedom,
                            plain_list(names_of(motion.check.undetermined, name))),
                completions_text(motion.check, name));
  }
}

// "body 'planet5' can turn about the axis (0, 0, 1) through (0, 17, 0)", lengths in file units.
std::string unheld_text(const Analysis& analysis, const UnheldMotion& unheld) {
  const auto axis = find_axis(unheld.twist, analysis.mechanism.geometry.length);
  const std::string body = analysis.mechanism.topology.body(unheld.body).name;
  const auto triple = [](const Vec3& v) {
    const auto tidy = [](double x) { return std::abs(x) <= kRankZero ? 0.0 : x; };
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", tidy(v.x()), tidy(v.y()), tidy(v.z()));
  };
  if (!axis) {
    return fmt::format("body '{}' can move", body);
  }
  if (!axis->point) {
    return fmt::format("body '{}' can slide along {}", body, triple(axis->direction));
  }
  const FileUnits& units = analysis.description.units;
  const double scale = 1.0 / units.factor(QuantityKind::length);
  return fmt::format("body '{}' can turn about the axis {} through {} {}",
                     body,
                     triple(axis->direction),
                     triple(scale * *axis->point),
                     units.text(QuantityKind::length));
}

void add_action_findings(const Analysis& analysis, const CaseAnalysis& one, Diagnostics& found) {
  const StaticSolution& action = *one.action;
  const Topology& topology = analysis.mechanism.topology;
  const NameOf name = [&](int i) { return topology.action_name(i); };
  if (action.status == SolveStatus::inconsistent) {
    found.error("E0602",
                place_of_surplus(one.which.actions, action.check, one.which.where),
                fmt::format("case '{}' has no equilibrium: it demands {}{}{}",
                            one.which.label,
                            relations_text(action.check, name),
                            action.unheld ? "; nothing holds the load: " : "",
                            action.unheld ? unheld_text(analysis, *action.unheld) : ""),
                "leave open the action that holds this motion, or add what holds it");
  } else if (action.status == SolveStatus::dependent) {
    found.error("E0601",
                place_of_surplus(one.which.actions, action.check, one.which.where),
                fmt::format("case '{}': the known actions depend on each other: equilibrium "
                            "demands {}",
                            one.which.label,
                            relations_text(action.check, name)),
                "remove one of these actions");
  } else if (action.status == SolveStatus::underdetermined) {
    found.warning("W0601",
                  one.which.where,
                  fmt::format("case '{}' knows {} of the {} actions needed; equilibrium does not "
                              "determine {}",
                              one.which.label,
                              one.which.actions.size(),
                              action.counts.net_constraint,
                              plain_list(names_of(action.check.undetermined, name))),
                  completions_text(action.check, name));
  }
}

}  // namespace

void add_findings(const Analysis& analysis, Diagnostics& found) {
  for (const CaseAnalysis& one : analysis.cases) {
    if (one.motion) {
      add_motion_findings(analysis.mechanism.topology, one, found);
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
