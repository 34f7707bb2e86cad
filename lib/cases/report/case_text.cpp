#include "cases/report/case_text.hpp"

#include <utility>

#include <fmt/format.h>

#include "core/utf8.hpp"
#include "kinematics/bounded_motion.hpp"
#include "mechanism/label_kind.hpp"
#include "report/column_table.hpp"
#include "report/in_units.hpp"
#include "report/number_format.hpp"
#include "report/report_parts.hpp"
#include "report/table.hpp"

namespace kinestat {

namespace {

std::string known_text(const Topology& topology, const Case& which, const InUnits& in) {
  std::vector<std::string> parts;
  const auto unit = [&](QuantityKind kind) { return in.units().text(kind); };
  for (const Primary& primary : which.motions) {
    if (primary.is_assumed) {
      continue;
    }
    const bool turns = topology.freedoms[static_cast<std::size_t>(primary.index)].is_rotation;
    parts.push_back(fmt::format("{} = {} {}",
                                topology.freedom_name(primary.index),
                                format_short(in.rate(primary.value, turns)),
                                unit(rate_kind(turns))));
  }
  for (const Primary& primary : which.actions) {
    const bool turns = topology.actions[static_cast<std::size_t>(primary.index)].is_couple;
    parts.push_back(fmt::format("{} = {} {}",
                                topology.action_name(primary.index),
                                format_short(in.action(primary.value, turns)),
                                unit(action_kind(turns))));
  }
  for (const Load& load : which.loads) {
    parts.push_back("load " + load.name);
  }
  return fmt::format("  known: {}\n",
                     parts.empty() ? "nothing" : fmt::format("{}", fmt::join(parts, ", ")));
}

TextBlocks freedoms_blocks(const Topology& topology,
                           const KinematicSolution& motion,
                           const InUnits& in) {
  Table table({"Freedom", "velocity", "unit"});
  for (std::size_t f = 0; f < topology.freedoms.size(); ++f) {
    const bool turns = topology.freedoms[f].is_rotation;
    table.add({topology.freedom_name(static_cast<int>(f)),
               motion.knows_rate(static_cast<int>(f))
                   ? format_short(in.rate(motion.rates[f], turns))
                   : "-",
               in.units().text(rate_kind(turns))});
  }
  return TextBlocks(std::move(table));
}

TextBlocks bodies_blocks(const Mechanism& mechanism,
                         const KinematicSolution& motion,
                         const InUnits& in) {
  TextColumn names{.head = "Body", .cells = {}};
  VectorColumns angular{.symbol = "w",
                        .unit = in.units().text(QuantityKind::angular_velocity),
                        .rows = {},
                        .missing = "-"};
  VectorColumns linear{
      .symbol = "V", .unit = in.units().text(QuantityKind::velocity), .rows = {}, .missing = "-"};
  VectorColumns at{.symbol = "at ", .unit = in.units().text(QuantityKind::length), .rows = {}};
  for (std::size_t b = 1; b < mechanism.topology.bodies.size(); ++b) {
    const Vec3& reference = mechanism.geometry.references[b];
    const BodyId body{static_cast<int>(b)};
    const double length = mechanism.geometry.length;
    names.cells.push_back(mechanism.topology.bodies[b].name);
    const BoundedTwist twist = bounded_body(motion, body);
    angular.rows.push_back(motion.knows_turn(body, length)
                               ? std::optional(in.angular(twist.angular.zeroed()))
                               : std::nullopt);
    linear.rows.push_back(motion.knows_velocity(body, reference, length)
                              ? std::optional(in.linear(velocity_at(twist, reference).zeroed()))
                              : std::nullopt);
    at.rows.emplace_back(in.length(mechanism.geometry.origin.in_world(reference)));
  }
  std::vector<TextColumn> columns = {std::move(names)};
  angular.add_to(columns);
  linear.add_to(columns);
  at.add_to(columns);
  return TextBlocks(std::move(columns));
}

TextBlocks motion_blocks(const Mechanism& mechanism,
                         const KinematicSolution& motion,
                         const InUnits& in) {
  if (motion.status != SolveStatus::solved) {
    return TextBlocks(fmt::format("  kinematics: {}\n\n", word_of(motion.status)));
  }
  TextBlocks blocks = freedoms_blocks(mechanism.topology, motion, in);
  return blocks += bodies_blocks(mechanism, motion, in);
}

}  // namespace

CaseBlocks case_blocks(const Analysis& analysis, const CaseAnalysis& one) {
  const Mechanism& mechanism = analysis.mechanism;
  const InUnits in(analysis.description.units);
  CaseBlocks blocks;
  blocks.known = known_text(mechanism.topology, one.which, in);
  blocks.results = results_text(analysis, one);
  if (one.motion) {
    blocks.motion = motion_blocks(mechanism, *one.motion, in);
  }
  if (one.action) {
    blocks.action = statics_blocks(mechanism, one, in);
  }
  if (one.power) {
    blocks.power = power_blocks(mechanism, one, in);
  }
  if (one.dynamics) {
    blocks.dynamics = dynamics_blocks(mechanism, one, in);
  }
  blocks.affine = affine_text(analysis, one);
  return blocks;
}

TextBlocks case_text(const Analysis& analysis, const CaseAnalysis& one) {
  CaseBlocks blocks = case_blocks(analysis, one);
  TextBlocks all(fmt::format(
      "Case {}{}\n", printable(one.which.label), in_drawn_position(analysis.description)));
  all += blocks.known;
  all += blocks.results;
  all += "\n";
  all += std::move(blocks.motion);
  all += std::move(blocks.action);
  all += std::move(blocks.power);
  all += std::move(blocks.dynamics);
  all += blocks.affine;
  return all;
}

}  // namespace kinestat
