#include <utility>

#include <fmt/format.h>

#include "cases/report/case_text.hpp"
#include "report/column_table.hpp"
#include "report/number_format.hpp"
#include "report/table.hpp"

namespace kinestat {

namespace {

TextBlocks accelerations_blocks(const Mechanism& mechanism,
                                const CaseDynamics& one,
                                const FileUnits& units) {
  TextColumn names{.head = "Inertia of", .cells = {}};
  VectorColumns angular{
      .symbol = "alpha", .unit = units.text(QuantityKind::angular_acceleration), .rows = {}};
  VectorColumns linear{.symbol = "a", .unit = units.text(QuantityKind::acceleration), .rows = {}};
  VectorColumns force{.symbol = "F", .unit = units.text(QuantityKind::force), .rows = {}};
  TextColumn energy{.head = fmt::format("energy [{}]", units.text(QuantityKind::energy)),
                    .cells = {}};
  for (const BodyDynamics& body : one.bodies) {
    names.cells.push_back(mechanism.topology.body(body.body).name);
    angular.rows.emplace_back(body.angular_acceleration);
    linear.rows.emplace_back(body.centre_acceleration / units.factor(QuantityKind::acceleration));
    force.rows.emplace_back(body.inertial.force / units.factor(QuantityKind::force));
    energy.cells.push_back(format_short(units.from_si(QuantityKind::energy, body.kinetic_energy)));
  }
  std::vector<TextColumn> columns = {std::move(names)};
  angular.add_to(columns);
  linear.add_to(columns);
  force.add_to(columns);
  columns.push_back(std::move(energy));
  return TextBlocks(std::move(columns));
}

TextBlocks reduced_blocks(const Topology& topology,
                          const ReducedEquation& equation,
                          const FileUnits& units) {
  Table table({"At", "equivalent inertia", "unit", "action at constant speed", "unit"});
  for (std::size_t d = 0; d < equation.drives.size(); ++d) {
    const auto f = static_cast<std::size_t>(equation.drives[d]);
    const bool turns = topology.freedoms[f].is_rotation;
    const auto i = static_cast<Eigen::Index>(d);
    const QuantityKind inertia = turns ? QuantityKind::inertia : QuantityKind::mass;
    const QuantityKind action = turns ? QuantityKind::moment : QuantityKind::force;
    table.add({topology.freedom_name(equation.drives[d]),
               format_short(units.from_si(inertia, equation.inertia(i, i))),
               units.text(inertia),
               format_short(units.from_si(action, equation.bias[i])),
               units.text(action)});
  }
  return TextBlocks(std::move(table));
}

}  // namespace

TextBlocks dynamics_blocks(const Mechanism& mechanism, const CaseAnalysis& one, const InUnits& in) {
  const CaseDynamics& dynamics = *one.dynamics;
  if (dynamics.bodies.empty()) {
    return {};
  }
  const FileUnits& units = in.units();
  TextBlocks blocks = accelerations_blocks(mechanism, dynamics, units);
  if (dynamics.reduced) {
    blocks += reduced_blocks(mechanism.topology, *dynamics.reduced, units);
  }
  blocks += TextBlocks(
      fmt::format("  kinetic energy {} {}, rate of change {} {}\n\n",
                  format_short(units.from_si(QuantityKind::energy, dynamics.kinetic_energy)),
                  units.text(QuantityKind::energy),
                  format_short(units.from_si(QuantityKind::power, dynamics.kinetic_energy_rate)),
                  units.text(QuantityKind::power)));
  return blocks;
}

}  // namespace kinestat
