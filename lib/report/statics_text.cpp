#include "report/statics_text.hpp"

#include <string_view>

#include <fmt/format.h>

#include "report/column_table.hpp"
#include "report/numbers.hpp"
#include "report/table.hpp"

namespace kinestat {

namespace {

std::string actuators_text(const Topology& topology, const CaseAnalysis& one, const InUnits& in) {
  if (topology.actuators.empty()) {
    return {};
  }
  const bool has_power = one.power.has_value();
  std::vector<std::string> head = {"Actuator", "action", "unit"};
  if (has_power) {
    head.push_back(fmt::format("power [{}]", in.units().text(QuantityKind::power)));
  }
  Table table(std::move(head));
  for (std::size_t i = 0; i < topology.actuators.size(); ++i) {
    const auto a = static_cast<std::size_t>(topology.actuators[i].action);
    const bool turns = topology.actions[a].is_couple;
    const std::optional<double> magnitude = one.action->magnitudes[a];
    std::vector<std::string> row = {
        topology.actuators[i].name,
        cell_of(magnitude ? std::optional(in.action(*magnitude, turns)) : std::nullopt),
        in.units().text(turns ? QuantityKind::moment : QuantityKind::force)};
    if (has_power) {
      row.push_back(format_short(in.power(one.power->actuators[i])));
    }
    table.add(std::move(row));
  }
  return table.text("  ") + "\n";
}

std::string wrenches_text(const Mechanism& mechanism,
                          const StaticSolution& action,
                          const InUnits& in) {
  TextColumn names{.head = "Coupling", .cells = {}};
  VectorColumns force{.symbol = "F", .unit = in.units().text(QuantityKind::force), .rows = {}};
  VectorColumns moment{.symbol = "T", .unit = in.units().text(QuantityKind::moment), .rows = {}};
  for (std::size_t e = 0; e < mechanism.topology.couplings.size(); ++e) {
    names.cells.push_back(mechanism.topology.couplings[e].name);
    const std::optional<Wrench>& wrench = action.wrenches[e];
    if (wrench) {
      force.rows.emplace_back(in.force(wrench->force));
      moment.rows.emplace_back(
          in.moment(moment_at(*wrench, mechanism.geometry.points[e] - mechanism.geometry.origin)));
    } else {
      force.rows.emplace_back(std::nullopt);
      moment.rows.emplace_back(std::nullopt);
    }
  }
  std::vector<TextColumn> columns = {std::move(names)};
  force.add_to(columns);
  moment.add_to(columns);
  return table_text(columns);
}

// Every passive action by itself, "?" where equilibrium does not determine it.
std::string constraints_text(const Topology& topology,
                             const StaticSolution& action,
                             const InUnits& in) {
  Table table({"Action", "magnitude", "unit"});
  for (std::size_t a = 0; a < topology.actions.size(); ++a) {
    if (topology.actions[a].actuator >= 0) {
      continue;
    }
    const bool turns = topology.actions[a].is_couple;
    const std::optional<double> magnitude = action.magnitudes[a];
    table.add({topology.action_name(static_cast<int>(a)),
               cell_of(magnitude ? std::optional(in.action(*magnitude, turns)) : std::nullopt),
               in.units().text(turns ? QuantityKind::moment : QuantityKind::force)});
  }
  return table.text("  ") + "\n";
}

// Moments are about the point where the force acts; those of a couple alone are the same anywhere.
std::string loads_text(const Mechanism& mechanism, const CaseAnalysis& one, const InUnits& in) {
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
    moment.rows.emplace_back(in.moment(couple_of(load, mechanism.geometry.origin)));
    at.rows.push_back(load.point ? std::optional(in.length(*load.point)) : std::nullopt);
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
  return one.which.loads.empty() ? "" : table_text(columns);
}

std::string friction_text(const Mechanism& mechanism, const CaseAnalysis& one, const InUnits& in) {
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
    std::vector<std::string> row = {
        mechanism.topology.coupling(friction.coupling).name,
        format_short(in.action(friction.magnitude, friction.is_couple)),
        in.units().text(friction.is_couple ? QuantityKind::moment : QuantityKind::force)};
    if (one.power) {
      row.push_back(format_short(in.power(one.power->friction[i])));
    }
    table.add(std::move(row));
  }
  return table.text("  ") + "\n";
}

std::string efficiency_text(const PowerFlow& flow) {
  if (flow.is_self_locking) {
    return "; self-locking: friction takes more than the inputs give";
  }
  return flow.efficiency ? fmt::format("; efficiency {}", format_short(*flow.efficiency)) : "";
}

std::string power_text(const PowerFlow& flow, const InUnits& in) {
  const std::string_view all =
      flow.loads.empty() ? "the powers of all couplings" : "the powers of all couplings and loads";
  return fmt::format(
      "  input power {} {}{}; {}\n\n",
      format_short(in.power(flow.input)),
      in.units().text(QuantityKind::power),
      efficiency_text(flow),
      flow.is_balanced
          ? fmt::format("{} sum to zero", all)
          : fmt::format("{} sum to {:.3g} of the largest", all, flow.balance_residual));
}

}  // namespace

std::string statics_text(const Mechanism& mechanism, const CaseAnalysis& one, const InUnits& in) {
  if (one.action->wrenches.empty()) {
    return fmt::format("  statics: {}\n\n", word_of(one.action->status));
  }
  const bool is_solved = one.action->status == SolveStatus::solved;
  std::string text = is_solved ? "" : fmt::format("  statics: {}\n\n", word_of(one.action->status));
  text += actuators_text(mechanism.topology, one, in);
  text += is_solved ? wrenches_text(mechanism, *one.action, in)
                    : constraints_text(mechanism.topology, *one.action, in);
  text += loads_text(mechanism, one, in) + friction_text(mechanism, one, in);
  if (one.power) {
    text += power_text(*one.power, in);
  }
  return text;
}

}  // namespace kinestat
