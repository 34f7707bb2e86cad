#include "sensitivity/adjoint.hpp"

#include <cmath>
#include <utility>

#include "core/tolerance.hpp"
#include "math/elimination.hpp"
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

// d screw / d parameter
Vec6 slope_of(const Vec6Of<Dual>& screw, std::size_t parameter) {
  Vec6 result;
  for (int i = 0; i < 6; ++i) {
    result[i] = derivative(screw[i], parameter);
  }
  return result;
}

// Adds factor · screw, in the coordinates of the basis, at the rows that begin with `first`.
void add(const Vec6& screw,
         double factor,
         const CoordinateBasis& basis,
         int first,
         std::vector<std::pair<int, double>>& rows) {
  if (screw.isZero(0.0)) {
    return;
  }
  const VecX coordinates = factor * basis.coordinates_of(screw);
  for (int i = 0; i < basis.order(); ++i) {
    if (coordinates[i] != 0.0) {
      rows.emplace_back(first + i, coordinates[i]);
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
      is_possible_.push_back(elimination_.is_consistent(change.known, right_hand_side(change)));
    }
  }

  // Adds the part of a value that moves by dv/dmagnitude with the magnitudes of this side. A
  // parameter whose change the redundant equations forbid leaves no value.
  void add(const std::vector<double>& slopes, std::vector<std::optional<Sum>>& result) const {
    VecX gradient = VecX::Zero(column_count_);
    for (std::size_t i = 0; i < slopes.size(); ++i) {
      gradient[first_column_ + static_cast<int>(i)] = slopes[i] * units_[i];
    }
    if (gradient.isZero(0.0)) {
      return;
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

// Moving a unit motion moves its coupling's twist by rate · d$: + Σ φ d$ on the right of
// t_head - t_tail - Σ φ $ = 0.
std::vector<Change> motion_changes(const DualCase& values,
                                   const MechanismDerivatives& derivatives,
                                   const CaseDerivatives& primaries,
                                   const CoordinateBasis& basis) {
  const Topology& topology = values.topology();
  std::vector<Change> changes(values.parameter_count());
  for (std::size_t p = 0; p < changes.size(); ++p) {
    for (std::size_t f = 0; f < topology.freedoms.size(); ++f) {
      const Vec6 screw = slope_of(derivatives.geometry.motions[f].coordinates(), p);
      const int first = basis.order() * topology.freedoms[f].coupling.value;
      add(screw, values.motion()->rates[f], basis, first, changes[p].rows);
    }
    for (std::size_t i = 0; i < primaries.motions.size(); ++i) {
      const double unit = rate_unit(topology, basis, values.which().motions[i].index);
      changes[p].known.push_back(derivative(primaries.motions[i], p) / unit);
    }
  }
  return changes;
}

// The wrench of a coupling changes by ψ d$ on its head, and by the opposite on its tail; a load
// adds to the left side of the equations, too.
std::vector<Change> action_changes(const DualCase& values,
                                   const MechanismDerivatives& derivatives,
                                   const CaseDerivatives& primaries,
                                   const CoordinateBasis& basis) {
  const Topology& topology = values.topology();
  std::vector<Change> changes(values.parameter_count());
  for (std::size_t p = 0; p < changes.size(); ++p) {
    for (std::size_t a = 0; a < topology.actions.size(); ++a) {
      const Vec6 screw = slope_of(derivatives.geometry.actions[a].coordinates(), p);
      const double size = values.action()->magnitudes[a].value_or(0.0);
      const CouplingTopology& coupling = topology.coupling(topology.actions[a].coupling);
      if (coupling.head.value > 0) {
        add(screw, -size, basis, basis.order() * (coupling.head.value - 1), changes[p].rows);
      }
      if (coupling.tail.value > 0) {
        add(screw, size, basis, basis.order() * (coupling.tail.value - 1), changes[p].rows);
      }
    }
    for (std::size_t i = 0; i < primaries.loads.size(); ++i) {
      const int body = values.which().loads[i].acts.body.value;
      const Vec6 screw = slope_of(primaries.loads[i].coordinates(), p);
      add(screw, -1.0, basis, basis.order() * (body - 1), changes[p].rows);
    }
    for (std::size_t i = 0; i < primaries.actions.size(); ++i) {
      const double unit = action_unit(topology, basis, values.which().actions[i].index);
      changes[p].known.push_back(derivative(primaries.actions[i], p) / unit);
    }
  }
  return changes;
}

// All coordinates of the space, so that a parameter that leaves the minimal ones is seen.
CoordinateBasis whole_basis(const Mechanism& mechanism, OrderChoice order, ScrewKind kind) {
  const bool is_planar = mechanism.space == Space::planar && order != OrderChoice::spatial;
  return is_planar ? planar_basis(kind, mechanism.geometry.length)
                   : spatial_basis(kind, mechanism.geometry.length);
}

}  // namespace

CaseAdjoint::CaseAdjoint(const DualCase& values,
                         const MechanismDerivatives& derivatives,
                         const CaseDerivatives& primaries)
    : values_(values) {
  const Mechanism& mechanism = values.mechanism();
  const Topology& topology = mechanism.topology;
  if (values.motion() != nullptr) {
    const auto basis = whole_basis(mechanism, mechanism.kinematic_order, ScrewKind::twist);
    std::vector<double> units;
    for (int f = 0; f < topology.freedom_count(); ++f) {
      units.push_back(rate_unit(topology, basis, f));
    }
    motion_ = std::make_unique<Side>(velocity_system(topology, mechanism.geometry, basis),
                                     values.which().motions,
                                     velocity_column(topology, basis, 0),
                                     std::move(units),
                                     motion_changes(values, derivatives, primaries, basis));
  }
  if (values.action() != nullptr) {
    const auto basis = whole_basis(mechanism, mechanism.static_order, ScrewKind::wrench);
    std::vector<double> units;
    for (int a = 0; a < topology.action_count(); ++a) {
      units.push_back(action_unit(topology, basis, a));
    }
    action_ = std::make_unique<Side>(action_system(topology, mechanism.geometry, basis),
                                     values.which().actions,
                                     0,
                                     std::move(units),
                                     action_changes(values, derivatives, primaries, basis));
  }
}

CaseAdjoint::~CaseAdjoint() = default;

std::vector<std::optional<double>> CaseAdjoint::derivatives_of(const ReportedValue& value) const {
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
  if (motion_) {
    motion_->add(slopes(0, rates), sums);
  }
  if (action_) {
    action_->add(slopes(rates, actions), sums);
  }
  std::vector<std::optional<double>> result;
  for (const std::optional<Sum>& sum : sums) {
    const bool has_value = sum && std::isfinite(sum->value);
    result.push_back(has_value ? std::optional(sum->rounded()) : std::nullopt);
  }
  return result;
}

}  // namespace kinestat
