#include "sensitivity/adjoint.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include "core/tolerance.hpp"
#include "math/elimination.hpp"
#include "network/bases.hpp"
#include "network/node_system.hpp"

namespace kinestat {

namespace {

// A change of the right-hand side that a parameter causes, per SI unit of it.
struct Change {
  std::vector<std::pair<int, double>> rows;  ///< row of the equations, change
  std::vector<double> known;                 ///< of the primaries, in the units of the unknowns
};

// A sum with the size of its terms, by which it counts as zero if it is their rounding.
struct Sum {
  double value = 0.0;
  double size = 0.0;

  void add(double term) {
    value += term;
    size += std::abs(term);
  }

  double rounded() const { return std::abs(value) <= kCancellation * size ? 0.0 : value; }
};

bool is_zero(const std::vector<double>& slopes) {
  return std::ranges::all_of(slopes, [](double slope) { return slope == 0.0; });
}

// The three coordinates that begin a screw, and the three that end it.
std::array<const Vec3Of<Dual>*, 2> halves(const TwistOf<Dual>& twist) {
  return {&twist.angular, &twist.linear};
}

std::array<const Vec3Of<Dual>*, 2> halves(const WrenchOf<Dual>& wrench) {
  return {&wrench.moment, &wrench.force};
}

// Calls slope(p, i, d coordinate i / d parameter p) for every parameter that moves a coordinate of
// the screw.
template <class Screw, class Slope>
void for_each_slope(const Screw& screw, const Slope& slope) {
  int i = 0;
  for (const Vec3Of<Dual>* half : halves(screw)) {
    for (const Dual& coordinate : *half) {
      const std::vector<double>& by_parameter = coordinate.derivatives;
      for (std::size_t p = 0; p < by_parameter.size(); ++p) {
        if (by_parameter[p] != 0.0) {
          slope(p, i, by_parameter[p]);
        }
      }
      ++i;
    }
  }
}

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

std::vector<int> columns_of(const std::vector<Primary>& primaries, int first) {
  std::vector<int> columns;
  for (const Primary& primary : primaries) {
    columns.push_back(first + primary.index);
  }
  return columns;
}

}  // namespace

// The equations of one side: their factors, the unit of each magnitude, and what every parameter
// changes.
class CaseAdjoint::Side {
 public:
  Side(SparseMatrix system,
       const std::vector<Primary>& primaries,
       int first_column,
       std::vector<double> units,
       std::vector<Change> changes)
      : row_count_(static_cast<std::size_t>(system.rows)),
        column_count_(system.columns),
        elimination_(std::move(system), columns_of(primaries, first_column)),
        first_column_(first_column),
        units_(std::move(units)),
        changes_(std::move(changes)) {
    for (const Change& change : changes_) {
      is_possible_.push_back(is_nothing(change) ||
                             elimination_.is_consistent(change.known, right_hand_side(change)));
    }
  }

  // Adds the part of a value that moves by dv/dmagnitude with the magnitudes of this side. A
  // parameter whose change the redundant equations forbid leaves no value.
  void add(const std::vector<double>& slopes, std::vector<std::optional<Sum>>& result) const {
    VecX gradient = VecX::Zero(column_count_);
    for (std::size_t i = 0; i < slopes.size(); ++i) {
      gradient[first_column_ + static_cast<int>(i)] = slopes[i] * units_[i];
    }
    const AdjointSolution adjoint = elimination_.solve_adjoint(gradient);
    for (std::size_t p = 0; p < changes_.size(); ++p) {
      if (!is_possible_[p]) {
        result[p] = std::nullopt;
      } else if (result[p]) {
        add(adjoint, changes_[p], *result[p]);
      }
    }
  }

 private:
  static bool is_nothing(const Change& change) {
    return change.rows.empty() && is_zero(change.known);
  }

  std::vector<double> right_hand_side(const Change& change) const {
    std::vector<double> rhs(row_count_, 0.0);
    for (const auto& [row, value] : change.rows) {
      rhs[static_cast<std::size_t>(row)] += value;
    }
    return rhs;
  }

  static void add(const AdjointSolution& adjoint, const Change& change, Sum& sum) {
    for (const auto& [row, value] : change.rows) {
      sum.add(adjoint.rows[row] * value);
    }
    for (std::size_t i = 0; i < change.known.size(); ++i) {
      sum.add(adjoint.known[static_cast<Eigen::Index>(i)] * change.known[i]);
    }
  }

  std::size_t row_count_;
  int column_count_;
  Elimination elimination_;
  int first_column_;
  std::vector<double> units_;
  std::vector<Change> changes_;    ///< of each parameter
  std::vector<bool> is_possible_;  ///< likewise
};

namespace {

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

// Moving a unit motion moves its coupling's twist by rate · d$: + Σ φ d$ on the right of
// t_head - t_tail - Σ φ $ = 0.
std::vector<Change> motion_changes(const DualCase& values,
                                   std::span<const TwistOf<Dual>> screws,
                                   const CaseDerivatives& primaries,
                                   const CoordinateBasis& basis) {
  const Topology& topology = values.topology();
  std::vector<Change> changes(values.parameter_count());
  for (std::size_t f = 0; f < topology.freedoms.size(); ++f) {
    const int first = basis.order() * topology.freedoms[f].coupling.value;
    const double rate = values.motion()->rates[f];
    for_each_slope(screws[f], [&](std::size_t p, int i, double slope) {
      add(rate * slope, i, basis, first, changes[p].rows);
    });
  }
  std::vector<double> units;
  for (const Primary& primary : values.which().motions) {
    units.push_back(rate_unit(topology, basis, primary.index));
  }
  add_known(primaries.motions, units, changes);
  return changes;
}

// The wrench of a coupling changes by ψ d$ on its head, and by the opposite on its tail; a load
// adds to the left side of the equations, too.
std::vector<Change> action_changes(const DualCase& values,
                                   std::span<const WrenchOf<Dual>> screws,
                                   const CaseDerivatives& primaries,
                                   const CoordinateBasis& basis) {
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
    add_on(coupling.head, screws[a], size);
    add_on(coupling.tail, screws[a], -size);
  }
  for (std::size_t i = 0; i < primaries.loads.size(); ++i) {
    add_on(values.which().loads[i].acts.body, primaries.loads[i], 1.0);
  }
  std::vector<double> units;
  for (const Primary& primary : values.which().actions) {
    units.push_back(action_unit(topology, basis, primary.index));
  }
  add_known(primaries.actions, units, changes);
  return changes;
}

// Whether parameters move only such coordinates of the screws as the basis has.
template <class Screw>
bool holds_slopes(const CoordinateBasis& basis, const std::vector<Screw>& screws) {
  std::array<bool, 6> is_moved{};
  for (const Screw& screw : screws) {
    for_each_slope(
        screw, [&](std::size_t, int i, double) { is_moved[static_cast<std::size_t>(i)] = true; });
  }
  for (int i = 0; i < 6; ++i) {
    if (is_moved[static_cast<std::size_t>(i)] && !basis.holds(Vec6::Unit(i))) {
      return false;
    }
  }
  return true;
}

// All coordinates of the space.
CoordinateBasis whole_basis(const Mechanism& mechanism, OrderChoice order, ScrewKind kind) {
  const bool is_planar = mechanism.space == Space::planar && order != OrderChoice::spatial;
  return is_planar ? planar_basis(kind, mechanism.geometry.length)
                   : spatial_basis(kind, mechanism.geometry.length);
}

CoordinateBasis motion_basis_for(const Mechanism& mechanism,
                                 const MechanismDerivatives& derivatives) {
  CoordinateBasis minimal = motion_basis(mechanism.geometry, mechanism.kinematic_order);
  return holds_slopes(minimal, derivatives.geometry.motions)
             ? minimal
             : whole_basis(mechanism, mechanism.kinematic_order, ScrewKind::twist);
}

CoordinateBasis action_basis_for(const Mechanism& mechanism,
                                 const MechanismDerivatives& derivatives) {
  std::vector<BodyWrench> loads;
  for (const Case& one : mechanism.cases) {
    std::ranges::copy(wrenches_of(one.loads), std::back_inserter(loads));
  }
  CoordinateBasis minimal = action_basis(mechanism.geometry, mechanism.static_order, loads);
  const bool is_enough = holds_slopes(minimal, derivatives.geometry.actions) &&
                         std::ranges::all_of(derivatives.cases, [&](const CaseDerivatives& one) {
                           return holds_slopes(minimal, one.loads);
                         });
  return is_enough ? minimal : whole_basis(mechanism, mechanism.static_order, ScrewKind::wrench);
}

}  // namespace

AdjointBases find_adjoint_bases(const Mechanism& mechanism,
                                const MechanismDerivatives& derivatives) {
  return {.motion = motion_basis_for(mechanism, derivatives),
          .action = action_basis_for(mechanism, derivatives)};
}

CaseAdjoint::CaseAdjoint(const DualCase& values,
                         const AdjointBases& bases,
                         const MechanismDerivatives& derivatives,
                         const CaseDerivatives& primaries)
    : values_(values), bases_(bases), derivatives_(derivatives), primaries_(primaries) {}

CaseAdjoint::Side& CaseAdjoint::motion() {
  if (!motion_) {
    const GeometryOf<double>& geometry = values_.mechanism().geometry;
    const Topology& topology = values_.topology();
    std::vector<double> units;
    for (int f = 0; f < topology.freedom_count(); ++f) {
      units.push_back(rate_unit(topology, bases_.motion, f));
    }
    motion_ = std::make_unique<Side>(
        velocity_system(topology, geometry, bases_.motion),
        values_.which().motions,
        velocity_column(topology, bases_.motion, 0),
        std::move(units),
        motion_changes(values_, derivatives_.geometry.motions, primaries_, bases_.motion));
  }
  return *motion_;
}

CaseAdjoint::Side& CaseAdjoint::action() {
  if (!action_) {
    const GeometryOf<double>& geometry = values_.mechanism().geometry;
    const Topology& topology = values_.topology();
    std::vector<double> units;
    for (int a = 0; a < topology.action_count(); ++a) {
      units.push_back(action_unit(topology, bases_.action, a));
    }
    action_ = std::make_unique<Side>(
        action_system(topology, geometry, bases_.action),
        values_.which().actions,
        0,
        std::move(units),
        action_changes(values_, derivatives_.geometry.actions, primaries_, bases_.action));
  }
  return *action_;
}

CaseAdjoint::~CaseAdjoint() = default;

std::vector<std::optional<double>> CaseAdjoint::derivatives_of(const ReportedValue& value) {
  const Topology& topology = values_.topology();
  const auto slopes = [&](std::size_t first, std::size_t count) {
    std::vector<double> result(count);
    for (std::size_t i = 0; i < count; ++i) {
      result[i] = derivative(value.value, first + i);
    }
    return result;
  };
  const std::size_t rates = topology.freedoms.size();
  const std::size_t actions = topology.actions.size();
  std::vector<std::optional<Sum>> sums;
  for (const double direct : slopes(rates + actions, values_.parameter_count())) {
    sums.emplace_back(Sum{.value = direct, .size = std::abs(direct)});
  }
  const auto by_rates = slopes(0, rates);
  const auto by_actions = slopes(rates, actions);
  if (!is_zero(by_rates)) {
    motion().add(by_rates, sums);
  }
  if (!is_zero(by_actions)) {
    action().add(by_actions, sums);
  }
  std::vector<std::optional<double>> result;
  for (const std::optional<Sum>& sum : sums) {
    const bool has_value = sum && std::isfinite(sum->value);
    result.push_back(has_value ? std::optional(sum->rounded()) : std::nullopt);
  }
  return result;
}

}  // namespace kinestat
