#include "sensitivity/internal/change.hpp"

#include <algorithm>

#include "network/node_system.hpp"
#include "sensitivity/internal/screw_slopes.hpp"

namespace kinestat {

namespace {

// Adds `change` of coordinate i of a screw, in the coordinates of the basis, at the rows that begin
// with `first`.
void add(double change,
         int i,
         const CoordinateBasis& basis,
         int first,
         std::vector<std::pair<int, double>>& rows) {
  const double size = change / basis.unit[i];
  for (int r = 0; r < basis.order(); ++r) {
    if (basis.basis(i, r) != 0.0) {
      rows.emplace_back(first + r, basis.basis(i, r) * size);
    }
  }
}

// The slopes of the primaries, in the units of the unknowns.
void add_known(const std::vector<Dual>& primaries,
               const std::vector<double>& units,
               std::vector<Change>& changes) {
  for (std::size_t p = 0; p < changes.size(); ++p) {
    for (std::size_t i = 0; i < primaries.size(); ++i) {
      changes[p].known.push_back(derivative(primaries[i], p) / units[i]);
    }
  }
}

}  // namespace

bool Change::is_nothing() const {
  return rows.empty() && std::ranges::all_of(known, [](double slope) { return slope == 0.0; });
}

void add(const AdjointSolution& adjoint, const Change& change, Sum& sum) {
  for (const auto& [row, value] : change.rows) {
    sum.add(adjoint.rows[row] * value);
  }
  for (std::size_t i = 0; i < change.known.size(); ++i) {
    sum.add(adjoint.known[static_cast<Eigen::Index>(i)] * change.known[i]);
  }
}

// Moving a unit motion moves its coupling's twist by rate · d$: + Σ φ d$ on the right of
// t_head - t_tail - Σ φ $ = 0.
std::vector<Change> motion_changes(const DualCase& values, const CoordinateBasis& basis) {
  const Topology& topology = values.topology();
  std::vector<Change> changes(values.parameter_count());
  for (std::size_t f = 0; f < topology.freedoms.size(); ++f) {
    const int first = basis.order() * topology.freedoms[f].coupling.value;
    const double rate = values.motion()->rates[f];
    for_each_slope(values.derivatives().geometry.motions[f],
                   [&](std::size_t p, int i, double slope) {
                     add(rate * slope, i, basis, first, changes[p].rows);
                   });
  }
  std::vector<double> units;
  for (const Primary& primary : values.which().motions) {
    units.push_back(rate_unit(topology, basis, primary.index));
  }
  add_known(values.primaries().motions, units, changes);
  return changes;
}

// The wrench of a coupling changes by ψ d$ on its head, and by the opposite on its tail; a load
// adds to the left side of the equations, too.
std::vector<Change> action_changes(const DualCase& values, const CoordinateBasis& basis) {
  const Topology& topology = values.topology();
  std::vector<Change> changes(values.parameter_count());
  const auto add_on = [&](BodyId body, const WrenchOf<Dual>& wrench, double size) {
    if (body.value > 0) {
      for_each_slope(wrench, [&](std::size_t p, int i, double slope) {
        add(-size * slope, i, basis, basis.order() * (body.value - 1), changes[p].rows);
      });
    }
  };
  for (std::size_t a = 0; a < topology.actions.size(); ++a) {
    const double size = values.action()->magnitudes[a].value_or(0.0);
    const CouplingTopology& coupling = topology.coupling(topology.actions[a].coupling);
    add_on(coupling.head, values.derivatives().geometry.actions[a], size);
    add_on(coupling.tail, values.derivatives().geometry.actions[a], -size);
  }
  for (std::size_t i = 0; i < values.primaries().loads.size(); ++i) {
    add_on(values.which().loads[i].acts.body, values.primaries().loads[i], 1.0);
  }
  std::vector<double> units;
  for (const Primary& primary : values.which().actions) {
    units.push_back(action_unit(topology, basis, primary.index));
  }
  add_known(values.primaries().actions, units, changes);
  return changes;
}

}  // namespace kinestat
