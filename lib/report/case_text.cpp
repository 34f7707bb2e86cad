#include "report/case_text.hpp"

#include <array>

#include <fmt/format.h>

#include "core/utf8.hpp"
#include "report/affine_report.hpp"
#include "report/in_units.hpp"
#include "report/numbers.hpp"
#include "report/ratio_in_units.hpp"
#include "report/table.hpp"

namespace kinestat {

namespace {

constexpr std::array<const char*, 3> kLetters = {"x", "y", "z"};

// A vector quantity as table columns: "Fx [N]" and so on, only those that are not zero throughout.
struct VectorColumns {
  std::string symbol;
  std::string unit;
  std::vector<std::optional<Vec3>> rows;

  bool is_used(Eigen::Index i) const {
    for (const auto& row : rows) {
      if (row && (*row)[i] != 0.0) {
        return true;
      }
    }
    return false;
  }
};

std::string cell(const std::optional<double>& value) {
  return value ? format_short(*value) : "?";
}

// Rows of names with the used components of several vector quantities and one last column.
std::string vector_table(const std::string& title,
                         const std::vector<std::string>& names,
                         const std::vector<VectorColumns>& quantities) {
  std::vector<std::string> head = {title};
  std::vector<std::vector<std::string>> rows(names.size());
  for (std::size_t r = 0; r < names.size(); ++r) {
    rows[r].push_back(names[r]);
  }
  for (const VectorColumns& quantity : quantities) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      if (!quantity.is_used(i)) {
        continue;
      }
      head.push_back(fmt::format(
          "{}{} [{}]", quantity.symbol, kLetters[static_cast<std::size_t>(i)], quantity.unit));
      for (std::size_t r = 0; r < names.size(); ++r) {
        const auto& row = quantity.rows[r];
        rows[r].push_back(cell(row ? std::optional((*row)[i]) : std::nullopt));
      }
    }
  }
  Table table(std::move(head));
  for (auto& row : rows) {
    table.add(std::move(row));
  }
  return table.text("  ") + "\n";
}

std::string known_text(const Topology& topology, const Case& which, const InUnits& in) {
  std::vector<std::string> parts;
  const auto unit = [&](QuantityKind kind) { return in.units().text(kind); };
  for (const Primary& primary : which.motions) {
    const bool turns = topology.freedoms[static_cast<std::size_t>(primary.index)].is_rotation;
    parts.push_back(
        fmt::format("{} = {} {}",
                    topology.freedom_name(primary.index),
                    format_short(in.rate(primary.value, turns)),
                    unit(turns ? QuantityKind::angular_velocity : QuantityKind::velocity)));
  }
  for (const Primary& primary : which.actions) {
    const bool turns = topology.actions[static_cast<std::size_t>(primary.index)].is_couple;
    parts.push_back(fmt::format("{} = {} {}",
                                topology.action_name(primary.index),
                                format_short(in.action(primary.value, turns)),
                                unit(turns ? QuantityKind::moment : QuantityKind::force)));
  }
  return fmt::format("  known: {}\n",
                     parts.empty() ? "nothing" : fmt::format("{}", fmt::join(parts, ", ")));
}

std::string ratio_text(const CaseAnalysis& one,
                       const Mechanism& mechanism,
                       const FileUnits& units) {
  const RatioInUnits ratio = ratio_in_units(one, mechanism, units);
  const RatioInUnits torque = torque_ratio_in_units(one, mechanism, units);
  const auto shown = [](const RatioInUnits& r) {
    return format_short(*r.value) + (r.unit.empty() ? "" : " " + r.unit);
  };
  std::string text = ratio.value ? fmt::format("  ratio {}", shown(ratio))
                                 : fmt::format("  no ratio: {}", one.ratios->reason);
  if (torque.value) {
    text += fmt::format(", {} ratio {}", torque.unit.empty() ? "torque" : "action", shown(torque));
  }
  return text + "\n";
}

std::string freedoms_text(const Topology& topology,
                          const KinematicSolution& motion,
                          const InUnits& in) {
  Table table({"Freedom", "rate", "unit"});
  for (std::size_t f = 0; f < topology.freedoms.size(); ++f) {
    const bool turns = topology.freedoms[f].is_rotation;
    table.add({topology.freedom_name(static_cast<int>(f)),
               format_short(in.rate(motion.rates[f], turns)),
               in.units().text(turns ? QuantityKind::angular_velocity : QuantityKind::velocity)});
  }
  return table.text("  ") + "\n";
}

std::string bodies_text(const Mechanism& mechanism,
                        const KinematicSolution& motion,
                        const InUnits& in) {
  std::vector<std::string> names;
  VectorColumns angular{
      .symbol = "w", .unit = in.units().text(QuantityKind::angular_velocity), .rows = {}};
  VectorColumns linear{.symbol = "V", .unit = in.units().text(QuantityKind::velocity), .rows = {}};
  VectorColumns at{.symbol = "at ", .unit = in.units().text(QuantityKind::length), .rows = {}};
  for (std::size_t b = 1; b < mechanism.topology.bodies.size(); ++b) {
    const Vec3& reference = mechanism.geometry.references[b];
    names.push_back(mechanism.topology.bodies[b].name);
    angular.rows.emplace_back(in.angular(motion.bodies[b].angular));
    linear.rows.emplace_back(
        in.linear(velocity_at(motion.bodies[b], reference - mechanism.geometry.origin)));
    at.rows.emplace_back(in.length(reference));
  }
  return vector_table("Body", names, {angular, linear, at});
}

std::string motion_text(const Mechanism& mechanism,
                        const KinematicSolution& motion,
                        const InUnits& in) {
  if (motion.status != SolveStatus::solved) {
    return fmt::format("  kinematics: {}\n\n", word_of(motion.status));
  }
  return freedoms_text(mechanism.topology, motion, in) + bodies_text(mechanism, motion, in);
}

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
        magnitude ? format_short(in.action(*magnitude, turns)) : "?",
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
  std::vector<std::string> names;
  VectorColumns force{.symbol = "F", .unit = in.units().text(QuantityKind::force), .rows = {}};
  VectorColumns moment{.symbol = "T", .unit = in.units().text(QuantityKind::moment), .rows = {}};
  for (std::size_t e = 0; e < mechanism.topology.couplings.size(); ++e) {
    names.push_back(mechanism.topology.couplings[e].name);
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
  return vector_table("Coupling", names, {force, moment});
}

// Every action by itself, "?" where equilibrium does not determine it.
std::string actions_text(const Topology& topology,
                         const StaticSolution& action,
                         const InUnits& in) {
  Table table({"Action", "magnitude", "unit"});
  for (std::size_t a = 0; a < topology.actions.size(); ++a) {
    const bool turns = topology.actions[a].is_couple;
    const std::optional<double> magnitude = action.magnitudes[a];
    table.add({topology.action_name(static_cast<int>(a)),
               magnitude ? format_short(in.action(*magnitude, turns)) : "?",
               in.units().text(turns ? QuantityKind::moment : QuantityKind::force)});
  }
  return fmt::format("  statics: {}\n\n", word_of(action.status)) + table.text("  ") + "\n";
}

std::string power_text(const PowerFlow& flow, const InUnits& in) {
  return fmt::format("  input power {} {}; {}\n\n",
                     format_short(in.power(flow.input)),
                     in.units().text(QuantityKind::power),
                     flow.is_balanced
                         ? "the powers of all couplings sum to zero"
                         : fmt::format("the powers of all couplings sum to {:.3g} of the largest",
                                       flow.balance_residual));
}

std::string action_text(const Mechanism& mechanism, const CaseAnalysis& one, const InUnits& in) {
  if (one.action->wrenches.empty()) {
    return fmt::format("  statics: {}\n\n", word_of(one.action->status));
  }
  const bool is_solved = one.action->status == SolveStatus::solved;
  std::string text = is_solved ? actuators_text(mechanism.topology, one, in) +
                                     wrenches_text(mechanism, *one.action, in)
                               : actions_text(mechanism.topology, *one.action, in);
  if (one.power) {
    text += power_text(*one.power, in);
  }
  return text;
}

}  // namespace

std::string case_text(const Analysis& analysis, const CaseAnalysis& one) {
  const Mechanism& mechanism = analysis.mechanism;
  const InUnits in(analysis.description.units, find_zero_snap(one, mechanism.geometry.length));
  std::string text = fmt::format("Case {}\n", printable(one.which.label));
  text += known_text(mechanism.topology, one.which, in);
  if (one.ratios) {
    text += ratio_text(one, mechanism, analysis.description.units);
  }
  text += "\n";
  if (one.motion) {
    text += motion_text(mechanism, *one.motion, in);
  }
  if (one.action) {
    text += action_text(mechanism, one, in);
  }
  return text + affine_text(analysis, one);
}

}  // namespace kinestat
