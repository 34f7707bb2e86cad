#include "cases/findings/known_side.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/tolerance.hpp"
#include "mechanism/label_kind.hpp"

namespace kinestat {

namespace {

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

std::string in_brackets(const std::string& unit) {
  const bool is_plain = unit.find_first_of("*/ ") == std::string::npos;
  return is_plain ? unit : "(" + unit + ")";
}

// "2.5 ", with the units where those of the magnitudes differ: "2.5 (N*m)/N "; nothing for 1.
std::string factor_text(double share, const KnownSide& side, int of, int to) {
  const QuantityKind here = side.kind(of);
  const QuantityKind there = side.kind(to);
  if (here != there) {
    return fmt::format("{:.6g} {}/{} ",
                       share,
                       in_brackets(side.units.text(there)),
                       in_brackets(side.units.text(here)));
  }
  return std::abs(share - 1.0) <= kRankZero ? "" : fmt::format("{:.6g} ", share);
}

// "a.Rx = 2.5 b.Rx - c.Rx + 12 N", or "a.Rx = 0", as numbers in the units of the file.
std::string relation_text(const Dependence& dependence, const KnownSide& side) {
  const DependenceTerm& first = dependence.terms.front();
  const double size = first.coefficient * side.unit(first.index);
  std::string text;
  const auto add = [&](double share, const std::string& what) {
    text += text.empty() ? (share < 0 ? "-" : "") : (share < 0 ? " - " : " + ");
    text += what;
  };
  for (const DependenceTerm& term : std::span(dependence.terms).subspan(1)) {
    const double share = -term.coefficient * side.unit(term.index) / size;
    add(share, factor_text(std::abs(share), side, term.index, first.index) + side.name(term.index));
  }
  if (dependence.constant != 0.0) {
    const double value = dependence.constant / size;
    add(value, fmt::format("{:.6g} {}", std::abs(value), side.units.text(side.kind(first.index))));
  }
  return fmt::format("{} = {}", side.name(first.index), text.empty() ? "0" : text);
}

// The blocks of `order` equations to which some belong, each once.
std::vector<int> blocks_of(const std::vector<int>& equations, int order) {
  std::vector<int> blocks;
  for (const int equation : equations) {
    if (blocks.empty() || blocks.back() != equation / order) {
      blocks.push_back(equation / order);
    }
  }
  return blocks;
}

}  // namespace

KnownSide motion_side(const JudgedFile& file, const Case& which) {
  const Topology& topology = file.mechanism.topology;
  return {.name = [&](int i) { return name_in(which.motions, i, topology.freedom_name(i)); },
          .kind = [&](int i) { return kind_of(topology.freedoms[static_cast<std::size_t>(i)]); },
          .key = "motion",
          .actuator = [&](int i) { return actuator_of(topology, &ActuatorTopology::freedom, i); },
          .units = file.description.units,
          .is_typed = !which.is_gear};
}

KnownSide action_side(const JudgedFile& file, const Case& which) {
  const Topology& topology = file.mechanism.topology;
  return {.name = [&](int i) { return name_in(which.actions, i, topology.action_name(i)); },
          .kind = [&](int i) { return kind_of(topology.actions[static_cast<std::size_t>(i)]); },
          .key = "action",
          .actuator = [&](int i) { return actuator_of(topology, &ActuatorTopology::action, i); },
          .units = file.description.units,
          .is_typed = !which.is_gear};
}

std::vector<std::string> names_of(const std::vector<int>& indices, const KnownSide& side) {
  std::vector<std::string> names;
  for (const int i : indices) {
    names.push_back(side.name(i));
  }
  return names;
}

std::string completions_text(const PrimaryCheck& check, const KnownSide& side) {
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
    std::vector<std::string>& to = has_actuators ? sets : others;
    std::string text = set.size() == 1 ? listed : "{" + listed + "}";
    if (std::ranges::find(to, text) == to.end()) {  // long lists may differ in what is cut off
      to.push_back(std::move(text));
    }
  }
  const bool may_be_idle = side.key == "action" && !sets.empty();
  const bool is_single = !check.completions.empty() && check.completions.front().size() == 1;
  sets.insert(sets.end(), others.begin(), others.end());
  if (sets.empty() || !side.is_typed) {
    return {};
  }
  return fmt::format("add to '{}:' {}{} of {}{}",
                     side.key,
                     is_single ? "a value" : "values",
                     sets.size() == 1 ? "" : ", for example",
                     fmt::join(sets, " or "),
                     may_be_idle ? ", 0 where nothing acts" : "");
}

std::string circuits_text(const JudgedFile& file,
                          const KinematicSolution& motion,
                          const KnownSide& side) {
  std::vector<std::string> parts;
  for (const Dependence& dependence : motion.check.dependences) {
    std::vector<std::string> names;
    for (const int e : blocks_of(dependence.equations, motion.counts.order)) {
      names.push_back(file.mechanism.topology.couplings[static_cast<std::size_t>(e)].name);
    }
    parts.push_back(fmt::format(
        "closure of circuit {} requires {}", plain_list(names), relation_text(dependence, side)));
  }
  return fmt::format("{}", fmt::join(parts, " and "));
}

std::string cutsets_text(const JudgedFile& file,
                         const StaticSolution& action,
                         const KnownSide& side) {
  const Topology& topology = file.mechanism.topology;
  std::vector<std::string> parts;
  for (const Dependence& dependence : action.check.dependences) {
    std::vector<bool> is_inside(topology.bodies.size(), false);
    std::vector<std::string> bodies;
    for (const int block : blocks_of(dependence.equations, action.counts.order)) {
      const auto b = static_cast<std::size_t>(block + 1);  // the ground has no equations
      is_inside[b] = true;
      bodies.push_back(topology.bodies[b].name);
    }
    std::vector<std::string> cut;
    for (const CouplingTopology& coupling : topology.couplings) {
      if (is_inside[static_cast<std::size_t>(coupling.tail.value)] !=
          is_inside[static_cast<std::size_t>(coupling.head.value)]) {
        cut.push_back(coupling.name);
      }
    }
    parts.push_back(fmt::format("equilibrium of {} (cut-set {}) requires {}",
                                plain_list(bodies),
                                plain_list(cut),
                                relation_text(dependence, side)));
  }
  return fmt::format("{}", fmt::join(parts, " and "));
}

std::string removal_text(const PrimaryCheck& check, const KnownSide& side) {
  std::vector<std::string> sets;
  for (const std::vector<int>& set : check.removals) {
    std::vector<std::string> names;
    for (const int i : set) {
      names.push_back(fmt::format("'{}'", side.name(i)));
    }
    sets.push_back(set.size() == 1 ? names.front() : "{" + plain_list(names) + "}");
  }
  if (sets.empty()) {
    return fmt::format("remove from '{}:' what follows from the others", side.key);
  }
  return fmt::format("remove {} from '{}:'", fmt::join(sets, " or "), side.key);
}

SourceRange place_of_surplus(const std::vector<Primary>& primaries,
                             const PrimaryCheck& check,
                             SourceRange otherwise) {
  const auto at =
      std::ranges::find(primaries, check.dependences.front().terms.front().index, &Primary::index);
  return at == primaries.end() ? otherwise : at->where;
}

}  // namespace kinestat
