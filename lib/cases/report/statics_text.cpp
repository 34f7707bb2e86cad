#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cases/report/case_text.hpp"
#include "math/dense/readable_basis.hpp"
#include "mechanism/label_kind.hpp"
#include "report/number_format.hpp"
#include "statics/coupling_wrenches.hpp"

namespace kinestat {

namespace {

// What completes equilibrium has a star, what stays open is "?".
std::string magnitude_cell(const StaticSolution& action, int a, bool turns, const InUnits& in) {
  const std::optional<double> magnitude = action.magnitudes[static_cast<std::size_t>(a)];
  const std::string text =
      cell_of(magnitude ? std::optional(in.action(*magnitude, turns)) : std::nullopt);
  return is_completed(action, a) ? "*" + text : text;
}

TextBlocks actuators_blocks(const Topology& topology, const CaseAnalysis& one, const InUnits& in) {
  if (topology.actuators.empty()) {
    return {};
  }
  const bool has_power = one.power.has_value();
  std::vector<std::string> head = {"Actuator", "action", "unit"};
  if (has_power) {
    head.push_back(fmt::format("power [{}]", in.units().text(QuantityKind::power)));
  }
  const LossyState* const lossy =
      one.efficiency && one.efficiency->state ? &*one.efficiency->state : nullptr;
  if (lossy != nullptr) {
    head.insert(head.end(), {"with mesh losses", head.back()});
  }
  Table table(std::move(head));
  for (std::size_t i = 0; i < topology.actuators.size(); ++i) {
    const auto a = static_cast<std::size_t>(topology.actuators[i].action);
    const bool turns = topology.actions[a].is_couple;
    std::vector<std::string> row = {
        topology.actuators[i].name,
        magnitude_cell(*one.action, topology.actuators[i].action, turns, in),
        in.units().text(action_kind(turns))};
    if (has_power) {
      row.push_back(format_short(in.power(one.power->actuators[i])));
    }
    if (lossy != nullptr) {
      const std::optional<double>& action = lossy->actions[a];
      row.push_back(cell_of(action ? std::optional(in.action(*action, turns)) : std::nullopt));
      row.push_back(format_short(in.power(lossy->actuators[i])));
    }
    table.add(std::move(row));
  }
  return TextBlocks(std::move(table));
}

TextBlocks wrenches_blocks(const Mechanism& mechanism,
                           const StaticSolution& action,
                           const InUnits& in) {
  TextColumn names{.head = "Coupling", .cells = {}};
  VectorColumns force{.symbol = "F", .unit = in.units().text(QuantityKind::force), .rows = {}};
  VectorColumns moment{.symbol = "T", .unit = in.units().text(QuantityKind::moment), .rows = {}};
  for (std::size_t e = 0; e < mechanism.topology.couplings.size(); ++e) {
    names.cells.push_back(mechanism.topology.couplings[e].name);
    const auto wrench = bounded_wrench(action, CouplingId{static_cast<int>(e)});
    if (wrench) {
      force.rows.emplace_back(in.force(wrench->force.zeroed()));
      const Vec3 at = mechanism.geometry.points[e];
      moment.rows.emplace_back(in.moment(moment_at(*wrench, at).zeroed()));
    } else {
      force.rows.emplace_back(std::nullopt);
      moment.rows.emplace_back(std::nullopt);
    }
  }
  std::vector<std::string_view> about_origin;
  for (std::size_t e = 0; e < moment.rows.size(); ++e) {
    if (mechanism.is_unplaced[e] && moment.rows[e] && !moment.rows[e]->isZero(0.0)) {
      about_origin.push_back(mechanism.topology.couplings[e].name);
    }
  }
  std::vector<TextColumn> columns = {std::move(names)};
  force.add_to(columns);
  moment.add_to(columns);
  if (columns.size() == 1) {
    return {};
  }
  TextBlocks blocks(std::move(columns));
  if (!about_origin.empty()) {
    blocks += fmt::format("  moments of {} are about the origin; 'at' gives another point\n\n",
                          fmt::join(about_origin, ", "));
  }
  return blocks;
}

// Every passive action by itself, "?" where equilibrium does not determine it.
TextBlocks constraints_blocks(const Topology& topology,
                              const StaticSolution& action,
                              const InUnits& in) {
  Table table({"Action", "magnitude", "unit"});
  for (std::size_t a = 0; a < topology.actions.size(); ++a) {
    if (topology.actions[a].actuator >= 0) {
      continue;
    }
    const bool turns = topology.actions[a].is_couple;
    table.add({topology.action_name(static_cast<int>(a)),
               magnitude_cell(action, static_cast<int>(a), turns, in),
               in.units().text(action_kind(turns))});
  }
  return TextBlocks(std::move(table));
}

// "self-stress 1 of a, b: a.Rx = 1 N, b.Rx = -1 N"
std::string self_stresses_text(const Topology& topology,
                               const StaticSolution& action,
                               const InUnits& in) {
  const auto count = static_cast<std::size_t>(action.check.missing);
  if (action.self_stresses.empty() && count * topology.actions.size() > kLongestList) {
    return fmt::format("  {} self-stresses, too many to be listed\n\n", count);
  }
  const FileUnits& units = in.units();
  const auto kind = [&](int a) { return kind_of(topology.actions[static_cast<std::size_t>(a)]); };
  std::string text;
  for (std::size_t i = 0; i < action.self_stresses.size(); ++i) {
    std::vector<std::string> parts;
    for (const DependenceTerm& term : action.self_stresses[i].terms) {
      const int first = action.self_stresses[i].terms.front().index;
      const double size = term.coefficient * units.factor(kind(first));
      parts.push_back(fmt::format("{} = {} {}",
                                  topology.action_name(term.index),
                                  format_short(units.from_si(kind(term.index), size)),
                                  units.text(kind(term.index))));
    }
    text += fmt::format("  self-stress {}: {}\n", i + 1, fmt::join(parts, ", "));
  }
  return text.empty() ? "" : text + "\n";
}

// "statics: indeterminate; * of least norm, couples divided by 0.5 m"; empty if there is nothing
// to say.
std::string status_text(const StaticSolution& action, const InUnits& in) {
  std::string text;
  if (!action.completion.actions.empty()) {
    text = action.completion.by == IndeterminateChoice::minimum_norm
               ? fmt::format("; * a convention: least norm, couples divided by {} {}",
                             format_short(in.length(action.completion.length)),
                             in.units().text(QuantityKind::length))
               : "; * by the stiffness of couplings";
  }
  return action.status == SolveStatus::solved && text.empty()
             ? ""
             : fmt::format("  statics: {}{}\n\n", word_of(action.status), text);
}

// Moments are about the point where the force acts; those of a couple alone are the same anywhere.
TextBlocks loads_blocks(const Mechanism& mechanism, const CaseAnalysis& one, const InUnits& in) {
  const FileUnits& units = in.units();
  TextColumn names{.head = "Load", .cells = {}};
  TextColumn bodies{.head = "on", .cells = {}};
  VectorColumns force{.symbol = "F", .unit = units.text(QuantityKind::force), .rows = {}};
  VectorColumns moment{.symbol = "T", .unit = units.text(QuantityKind::moment), .rows = {}};
  VectorColumns at{
      .symbol = "at ", .unit = units.text(QuantityKind::length), .rows = {}, .missing = "-"};
  for (const Load& load : one.which.loads) {
    const Wrench& wrench = load.acts.wrench;
    names.cells.push_back(load.name);
    bodies.cells.push_back(mechanism.topology.body(load.acts.body).name);
    force.rows.emplace_back(in.force(wrench.force));
    moment.rows.emplace_back(in.moment(couple_of(load)));
    at.rows.push_back(
        load.point ? std::optional(in.length(mechanism.geometry.origin.in_world(*load.point)))
                   : std::nullopt);
  }
  std::vector<TextColumn> columns = {std::move(names), std::move(bodies)};
  force.add_to(columns);
  moment.add_to(columns);
  at.add_to(columns);
  if (one.power) {
    TextColumn power{.head = fmt::format("power [{}]", units.text(QuantityKind::power)),
                     .cells = {}};
    for (const double value : one.power->loads) {
      power.cells.push_back(format_short(in.power(value)));
    }
    columns.push_back(std::move(power));
  }
  return one.which.loads.empty() ? TextBlocks() : TextBlocks(std::move(columns));
}

TextBlocks friction_blocks(const Mechanism& mechanism, const CaseAnalysis& one, const InUnits& in) {
  if (one.action->friction.empty()) {
    return {};
  }
  std::vector<std::string> head = {"Friction", "magnitude", "unit"};
  if (one.power) {
    head.push_back(fmt::format("power [{}]", in.units().text(QuantityKind::power)));
  }
  Table table(std::move(head));
  for (std::size_t i = 0; i < one.action->friction.size(); ++i) {
    const FrictionAction& friction = one.action->friction[i];
    std::vector<std::string> row = {mechanism.topology.coupling(friction.coupling).name,
                                    format_short(in.action(friction.magnitude, friction.is_couple)),
                                    in.units().text(action_kind(friction.is_couple))};
    if (one.power) {
      row.push_back(format_short(in.power(one.power->friction[i])));
    }
    table.add(std::move(row));
  }
  return TextBlocks(std::move(table));
}

// What one of several equal planets has, where the table above has all of them together.
TextBlocks planets_blocks(const Mechanism& mechanism,
                          const StaticSolution& action,
                          const InUnits& in) {
  const Topology& topology = mechanism.topology;
  const bool is_uneven =
      std::ranges::any_of(mechanism.load_sharing, [](double sharing) { return sharing > 1.0; });
  std::vector<std::string> heads = {"Planets", "number", "each", "unit"};
  if (is_uneven) {
    heads.insert(heads.end() - 1, "most loaded");
  }
  Table table(std::move(heads));
  for (std::size_t a = 0; has_planets(mechanism) && a < topology.actions.size(); ++a) {
    const int count = mechanism.planet_counts[a];
    const bool turns = topology.actions[a].is_couple;
    const std::optional<double>& all = action.magnitudes[a];
    const auto cell = [&](double share) {
      return cell_of(all ? std::optional(in.action(*all * share / count, turns)) : std::nullopt);
    };
    if (count > 1) {
      std::vector<std::string> row = {
          topology.action_name(static_cast<int>(a)), fmt::format("{}", count), cell(1.0)};
      if (is_uneven) {
        row.push_back(cell(mechanism.load_sharing[a]));
      }
      row.push_back(in.units().text(action_kind(turns)));
      table.add(std::move(row));
    }
  }
  return has_planets(mechanism) ? TextBlocks(std::move(table)) : TextBlocks();
}

// Slip is shown where a cable slips.
TextBlocks contacts_blocks(const Mechanism& mechanism, const CaseAnalysis& one, const InUnits& in) {
  if (one.contacts.empty()) {
    return {};
  }
  const FileUnits& units = in.units();
  const auto head = [&](std::string_view what, QuantityKind kind) {
    return fmt::format("{} [{}]", what, units.text(kind));
  };
  Table table({"Contact",
               head("wrap", QuantityKind::angle),
               head("before", QuantityKind::force),
               head("after", QuantityKind::force),
               "ratio",
               "limit",
               head("slip", QuantityKind::velocity),
               "state"});
  for (std::size_t i = 0; i < one.contacts.size(); ++i) {
    const CableContactState& state = one.contacts[i];
    const std::optional<double>& wrap = mechanism.contacts[i].wrap;
    const auto force = [&](const std::optional<double>& v) {
      return cell_of(v ? std::optional(in.force(*v)) : std::nullopt);
    };
    table.add({mechanism.contacts[i].name,
               cell_of(wrap ? std::optional(in.angle(*wrap)) : std::nullopt),
               force(state.before),
               force(state.after),
               state.ratio ? format_short(*state.ratio) : "",
               state.limit ? format_short(*state.limit) : "",
               state.slip_speed ? format_short(in.linear(*state.slip_speed)) : "",
               std::string(word_of(state.belt_state))});
  }
  return TextBlocks(std::move(table));
}

TextBlocks converters_blocks(const Mechanism& mechanism,
                             const CaseAnalysis& one,
                             const InUnits& in) {
  if (one.converters.empty()) {
    return {};
  }
  const FileUnits& units = in.units();
  const std::string torque = fmt::format(" [{}]", units.text(QuantityKind::moment));
  Table table({"Torque converter",
               "speed ratio",
               "torque ratio",
               "pump" + torque,
               "turbine" + torque,
               "stator" + torque,
               "efficiency",
               fmt::format("loss [{}]", units.text(QuantityKind::power))});
  for (const ConverterState& state : one.converters) {
    table.add({mechanism.topology.coupling(state.coupling).name,
               cell_of(state.speed_ratio),
               format_short(state.torque_ratio),
               format_short(in.moment(state.pump_torque)),
               format_short(in.moment(state.turbine_torque)),
               format_short(in.moment(state.stator_torque)),
               cell_of(state.efficiency()),
               format_short(in.power(state.lost))});
  }
  return TextBlocks(std::move(table));
}

}  // namespace

TextBlocks statics_blocks(const Mechanism& mechanism, const CaseAnalysis& one, const InUnits& in) {
  const StaticSolution& action = *one.action;
  if (action.wrenches.empty()) {
    return TextBlocks(fmt::format("  statics: {}\n\n", word_of(action.status)));
  }
  TextBlocks blocks(status_text(action, in));
  blocks += actuators_blocks(mechanism.topology, one, in);
  if (action.status == SolveStatus::solved && action.completion.actions.empty()) {
    blocks += wrenches_blocks(mechanism, action, in);
  } else {
    blocks += constraints_blocks(mechanism.topology, action, in);
    blocks += self_stresses_text(mechanism.topology, action, in);
  }
  blocks += loads_blocks(mechanism, one, in);
  blocks += friction_blocks(mechanism, one, in);
  blocks += planets_blocks(mechanism, action, in);
  blocks += contacts_blocks(mechanism, one, in);
  return blocks += converters_blocks(mechanism, one, in);
}

}  // namespace kinestat
