#include "studies/mobility/redundancy.hpp"

#include <algorithm>

#include "core/tolerance.hpp"
#include "graph/circuit.hpp"
#include "math/dense/readable_basis.hpp"
#include "math/dense/span.hpp"
#include "math/elimination/echelon.hpp"
#include "math/elimination/elimination.hpp"
#include "screw/bounded_screw.hpp"

namespace kinestat {

namespace {

// What a coupling bears passively: its actions that do not depend on each other.
struct Bearing {
  std::vector<int> actions;
  MatX wrenches;  ///< a column an action, in the coordinates dual to those of the motions
};

// A wrench in the coordinates in which it works on twists.
VecX dual_coordinates(const CoordinateBasis& twists, const Wrench& wrench) {
  const Vec6 scaled = wrench.coordinates().cwiseProduct(twists.unit);
  return twists.basis.transpose() * scaled;
}

Bearing bearing_of(const Mechanism& mechanism, const CoordinateBasis& twists, CouplingId id) {
  const CouplingTopology& coupling = mechanism.topology.coupling(id);
  std::vector<int> actions;
  MatX all(twists.order(), coupling.action_count);
  for (int a = coupling.first_action; a < coupling.first_action + coupling.action_count; ++a) {
    const auto index = static_cast<std::size_t>(a);
    if (mechanism.topology.actions[index].actuator < 0) {
      all.col(static_cast<Eigen::Index>(actions.size())) =
          dual_coordinates(twists, mechanism.geometry.actions[index]);
      actions.push_back(a);
    }
  }
  Bearing bearing;
  const std::vector<int> chosen =
      independent_columns(all.leftCols(static_cast<Eigen::Index>(actions.size())));
  bearing.wrenches.resize(twists.order(), static_cast<Eigen::Index>(chosen.size()));
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const int a = actions[static_cast<std::size_t>(chosen[i])];
    bearing.actions.push_back(a);
    bearing.wrenches.col(static_cast<Eigen::Index>(i)) =
        dual_coordinates(twists, mechanism.geometry.actions[static_cast<std::size_t>(a)]);
  }
  return bearing;
}

class RedundancySearch {
 public:
  RedundancySearch(const Mechanism& mechanism, const CoordinateBasis& twists)
      : mechanism_(mechanism), topology_(mechanism.topology), twists_(twists) {
    for (int e = 0; e < topology_.coupling_count(); ++e) {
      bearings_.push_back(bearing_of(mechanism, twists, {e}));
    }
  }

  void run(Redundancies& result) {
    const Elimination elimination(equilibrium(), {});
    const std::size_t count = elimination.free_columns().size();
    result.borne = static_cast<int>(count);
    if (count == 0 || count * topology_.actions.size() > kLongestList) {
      return;
    }
    for (const Circuit& circuit : find_circuits(mechanism_.graph)) {
      add_circuit(circuit, result.constraints);
    }
    std::vector<VecX> circuit_stresses;
    for (const RedundantConstraint& one : result.constraints) {
      circuit_stresses.push_back(one.magnitudes);
    }
    std::vector<VecX> all;
    for (const VecX& vector : elimination.null_vectors()) {
      all.push_back(magnitudes_of(vector));
    }
    const Eigen::Index columns = topology_.action_count();
    const MatX rest =
        readable_basis(rows_of(all, columns), action_scales(), rows_of(circuit_stresses, columns));
    for (Eigen::Index j = 0; j < rest.rows(); ++j) {
      result.constraints.push_back(spread_constraint(rest.row(j)));
    }
  }

 private:
  // Of every moving body, columns in the order of the bearings.
  SparseMatrix equilibrium() const {
    const int order = twists_.order();
    SparseMatrix system;
    system.rows = order * (topology_.body_count() - 1);
    for (int e = 0; e < topology_.coupling_count(); ++e) {
      const CouplingTopology& coupling = topology_.coupling({e});
      const MatX& wrenches = bearings_[static_cast<std::size_t>(e)].wrenches;
      for (Eigen::Index i = 0; i < wrenches.cols(); ++i, ++system.columns) {
        for (int c = 0; c < order; ++c) {
          if (coupling.head.value > 0) {
            system.add(order * (coupling.head.value - 1) + c, system.columns, wrenches(c, i));
          }
          if (coupling.tail.value > 0) {
            system.add(order * (coupling.tail.value - 1) + c, system.columns, -wrenches(c, i));
          }
        }
      }
    }
    return system;
  }

  VecX magnitudes_of(const VecX& solution) const {
    VecX magnitudes = VecX::Zero(topology_.action_count());
    Eigen::Index column = 0;
    for (const Bearing& bearing : bearings_) {
      for (const int a : bearing.actions) {
        magnitudes[a] = solution[column++];
      }
    }
    return magnitudes;
  }

  VecX action_scales() const {
    VecX scales = VecX::Ones(topology_.action_count());
    for (int a = 0; a < topology_.action_count(); ++a) {
      if (topology_.actions[static_cast<std::size_t>(a)].is_couple) {
        scales[a] = mechanism_.geometry.length;
      }
    }
    return scales;
  }

  // The wrenches that every coupling of the circuit bears, forces first.
  void add_circuit(const Circuit& circuit, std::vector<RedundantConstraint>& list) const {
    std::vector<MatX> spans;
    for (const CircuitEdge& edge : circuit.edges) {
      spans.push_back(bearings_[static_cast<std::size_t>(edge.coupling.value)].wrenches);
      if (spans.back().cols() == 0) {
        return;
      }
    }
    const MatX common = intersect_spans(spans, twists_.order());
    const MatX wrenches = readable_wrenches(common);
    const Eigen::Index first_couple = first_couple_of(wrenches);
    for (Eigen::Index j = 0; j < wrenches.rows(); ++j) {
      const VecX wrench = wrenches.row(j);
      list.push_back(circuit_constraint(circuit, wrench));
      list.back().is_line_free = j < first_couple && is_line_free(wrenches, first_couple, j);
    }
  }

  // Rows: forces first, then couples, as those are what is left where there is no force.
  MatX readable_wrenches(const MatX& common) const {
    if (common.cols() == 0) {
      return {0, 6};
    }
    MatX rows(common.cols(), 6);
    for (Eigen::Index j = 0; j < common.cols(); ++j) {
      const Vec6 scaled = twists_.basis * common.col(j);
      const Vec6 wrench = scaled.cwiseQuotient(twists_.unit);
      rows.row(j) << wrench.tail<3>().transpose(), wrench.head<3>().transpose();
    }
    VecX scales(6);
    scales << Vec3::Ones(), Vec3::Constant(mechanism_.geometry.length);
    MatX basis = readable_basis(rows, scales);
    MatX swapped(basis.rows(), 6);
    swapped << basis.rightCols<3>(), basis.leftCols<3>();
    return swapped;
  }

  static Eigen::Index first_couple_of(const MatX& wrenches) {
    Eigen::Index row = 0;
    while (row < wrenches.rows() && !wrenches.row(row).tail<3>().isZero(0.0)) {
      ++row;
    }
    return row;
  }

  // A force shifts parallel to itself where the couples across it are redundant too.
  static bool is_line_free(const MatX& wrenches, Eigen::Index first_couple, Eigen::Index row) {
    const Eigen::Index couples = wrenches.rows() - first_couple;
    if (couples == 3) {
      return true;
    }
    if (couples < 2) {
      return false;
    }
    const Vec3 force = wrenches.row(row).tail<3>();
    const MatX along = wrenches.bottomLeftCorner(couples, 3) * force;
    return along.isZero(kParallelAxes);
  }

  // `dual` is a wrench [SI] in six coordinates of which those outside the basis are zero.
  RedundantConstraint circuit_constraint(const Circuit& circuit, const VecX& wrench) const {
    const Vec6 SI = wrench;
    const VecX dual = twists_.basis.transpose() * SI.cwiseProduct(twists_.unit);
    RedundantConstraint one;
    one.magnitudes = VecX::Zero(topology_.action_count());
    for (const CircuitEdge& edge : circuit.edges) {
      const Bearing& bearing = bearings_[static_cast<std::size_t>(edge.coupling.value)];
      const VecX shares = coordinates_in(bearing.wrenches, edge.sign * dual);
      for (std::size_t i = 0; i < bearing.actions.size(); ++i) {
        one.magnitudes[bearing.actions[i]] = shares[static_cast<Eigen::Index>(i)];
      }
    }
    snap(one.magnitudes);
    const double sign = sign_of_first(one.magnitudes);
    one.magnitudes *= sign;
    one.chord = circuit.chord;
    one.axis = find_axis(written(Wrench::from_coordinates(sign * SI)), mechanism_.geometry.length);
    one.wrenches = wrenches_of(one.magnitudes);
    return one;
  }

  static double sign_of_first(const VecX& magnitudes) {
    const auto first = std::ranges::find_if(magnitudes, [](double x) { return x != 0.0; });
    return first != magnitudes.end() && *first < 0.0 ? -1.0 : 1.0;
  }

  RedundantConstraint spread_constraint(const VecX& magnitudes) const {
    RedundantConstraint one;
    one.magnitudes = magnitudes;
    one.wrenches = wrenches_of(magnitudes);
    return one;
  }

  void snap(VecX& magnitudes) const {
    const VecX sizes = magnitudes.cwiseQuotient(action_scales()).cwiseAbs();
    const double zero = kRankZero * sizes.maxCoeff();
    magnitudes = (sizes.array() <= zero).select(0.0, magnitudes);
  }

  std::vector<Wrench> wrenches_of(const VecX& magnitudes) const {
    std::vector<Wrench> wrenches(topology_.couplings.size());
    for (int a = 0; a < topology_.action_count(); ++a) {
      const auto index = static_cast<std::size_t>(a);
      Wrench& sum = wrenches[static_cast<std::size_t>(topology_.actions[index].coupling.value)];
      sum = sum + magnitudes[a] * mechanism_.geometry.actions[index];
    }
    return wrenches;
  }

  const Mechanism& mechanism_;
  const Topology& topology_;
  const CoordinateBasis& twists_;
  std::vector<Bearing> bearings_;
};

}  // namespace

Redundancies find_redundancies(const Mechanism& mechanism,
                               const CoordinateBasis& twists,
                               int net_constraint) {
  Redundancies result{
      .order = twists.order(), .net_constraint = net_constraint, .borne = 0, .constraints = {}};
  if (twists.order() > 0) {
    RedundancySearch(mechanism, twists).run(result);
  }
  return result;
}

}  // namespace kinestat
