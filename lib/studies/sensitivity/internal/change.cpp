#include "studies/sensitivity/internal/change.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"
#include "network/node_system.hpp"
#include "studies/sensitivity/internal/screw_slopes.hpp"

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

// Coordinate i of a wrench on a body, which adds to the left side of its equilibrium.
void add_load(BodyId body, double size, int i, const CoordinateBasis& basis, Change& change) {
  if (body.value > 0) {
    add(-size, i, basis, basis.order() * (body.value - 1), change.rows);
  }
}

void add_load(
    BodyId body, const Wrench& wrench, double size, const CoordinateBasis& basis, Change& change) {
  const Vec6 coordinates = wrench.coordinates();
  for (int i = 0; i < 6; ++i) {
    add_load(body, size * coordinates[i], i, basis, change);
  }
}

// What each parameter changes of a wrench times `size`.
void add_load(BodyId body,
              const WrenchOf<Dual>& wrench,
              double size,
              const CoordinateBasis& basis,
              std::vector<Change>& changes) {
  for_each_slope(wrench, [&](std::size_t p, int i, double slope) {
    add_load(body, size * slope, i, basis, changes[p]);
  });
}

}  // namespace

bool Change::is_nothing() const {
  return rows.empty() && std::ranges::all_of(known, [](double slope) { return slope == 0.0; });
}

void add(const AdjointSolution& adjoint, const Change& change, Sum& sum) {
  for (const auto& [row, value] : change.rows) {
    if (adjoint.rows[row] != 0.0) {  // a value that a row does not reach feels no corner there
      sum.add(adjoint.rows[row] * value);
    }
  }
  for (std::size_t i = 0; i < change.known.size(); ++i) {
    sum.add(adjoint.known[static_cast<Eigen::Index>(i)] * change.known[i]);
  }
}

bool moves(const AdjointSolution& adjoint, const Change& change, double directly) {
  const double steepest = adjoint.rows.size() == 0 ? 0.0 : adjoint.rows.cwiseAbs().maxCoeff();
  double sum = directly;
  double size = std::abs(directly);
  for (const auto& [row, value] : change.rows) {
    sum += adjoint.rows[row] * value;
    size += steepest * std::abs(value);
  }
  for (std::size_t i = 0; i < change.known.size(); ++i) {
    const double term = adjoint.known[static_cast<Eigen::Index>(i)] * change.known[i];
    sum += term;
    size += std::abs(term);
  }
  return !(std::abs(sum) <= kConsistency * size);
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

Change known_actions(const DualCase& values, const CoordinateBasis& basis) {
  Change result;
  for (const Load& load : values.which().loads) {
    add_load(load.acts.body, load.acts.wrench, 1.0, basis, result);
  }
  for (const FrictionAction& friction : values.action()->friction) {
    add_pair(values.topology().coupling(friction.coupling), friction.wrench, basis, result);
  }
  for (const Primary& primary : values.which().actions) {
    result.known.push_back(primary.value / action_unit(values.topology(), basis, primary.index));
  }
  return result;
}

std::vector<Change> known_action_changes(const DualCase& values, const CoordinateBasis& basis) {
  std::vector<Change> changes(values.parameter_count());
  const std::vector<WrenchOf<Dual>>& loads = values.primaries().loads;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    add_load(values.which().loads[i].acts.body, loads[i], 1.0, basis, changes);
  }
  std::vector<double> units;
  for (const Primary& primary : values.which().actions) {
    units.push_back(action_unit(values.topology(), basis, primary.index));
  }
  add_known(values.primaries().actions, units, changes);
  return changes;
}

void add_pair(const CouplingTopology& coupling,
              const Wrench& wrench,
              const CoordinateBasis& basis,
              Change& change) {
  add_load(coupling.head, wrench, 1.0, basis, change);
  add_load(coupling.tail, wrench, -1.0, basis, change);
}

void add_pair_changes(const CouplingTopology& coupling,
                      const WrenchOf<Dual>& unit,
                      double size,
                      const CoordinateBasis& basis,
                      std::vector<Change>& changes) {
  add_load(coupling.head, unit, size, basis, changes);
  add_load(coupling.tail, unit, -size, basis, changes);
}

void add_action_changes(std::span<const double> magnitudes,
                        const DualCase& values,
                        const CoordinateBasis& basis,
                        std::vector<Change>& changes) {
  const Topology& topology = values.topology();
  for (std::size_t a = 0; a < magnitudes.size(); ++a) {
    if (magnitudes[a] != 0.0) {
      const CouplingTopology& coupling = topology.coupling(topology.actions[a].coupling);
      const WrenchOf<Dual>& screw = values.derivatives().geometry.actions[a];
      add_pair_changes(coupling, screw, magnitudes[a], basis, changes);
    }
  }
}

}  // namespace kinestat
