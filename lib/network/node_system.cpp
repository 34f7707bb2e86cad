#include "network/node_system.hpp"

namespace kinestat {

namespace {

// Adds sign · (the screw's coordinates in the basis) as a column piece that begins at `row`.
void add_screw(const Vec6& screw,
               const CoordinateBasis& basis,
               double sign,
               SparseEntry at,
               SparseMatrix& to) {
  for (int i = 0; i < basis.order(); ++i) {
    const double coordinate = basis.is_made_of_coordinates()
                                  ? screw[basis.coordinates[static_cast<std::size_t>(i)]]
                                  : basis.basis.col(i).dot(screw);
    to.add(at.row + i, at.column, sign * coordinate);
  }
}

}  // namespace

SparseMatrix velocity_system(const Topology& topology,
                             const Geometry& geometry,
                             const CoordinateBasis& basis) {
  const int order = basis.order();
  SparseMatrix system;
  system.rows = order * topology.coupling_count();
  system.columns = order * (topology.body_count() - 1) + topology.freedom_count();
  for (int e = 0; e < topology.coupling_count(); ++e) {
    const CouplingTopology& coupling = topology.couplings[static_cast<std::size_t>(e)];
    for (int i = 0; i < order; ++i) {
      if (coupling.head.value > 0) {
        system.add(order * e + i, order * (coupling.head.value - 1) + i, 1.0);
      }
      if (coupling.tail.value > 0) {
        system.add(order * e + i, order * (coupling.tail.value - 1) + i, -1.0);
      }
    }
    for (int f = coupling.first_freedom; f < coupling.first_freedom + coupling.freedom_count; ++f) {
      const Vec6 screw = geometry.motions[static_cast<std::size_t>(f)].coordinates();
      const SparseEntry at{
          .row = order * e, .column = velocity_column(topology, basis, f), .value = 0.0};
      add_screw(screw, basis, -1.0, at, system);
    }
  }
  return system;
}

int velocity_column(const Topology& topology, const CoordinateBasis& basis, int freedom) {
  return basis.order() * (topology.body_count() - 1) + freedom;
}

Twist body_twist(const VecX& solution, const CoordinateBasis& basis, BodyId body) {
  if (body.value == 0 || basis.order() == 0) {
    return {};
  }
  const Eigen::Index first = basis.order() * (body.value - 1);
  return Twist::from_coordinates(basis.basis * solution.segment(first, basis.order()));
}

SparseMatrix action_system(const Topology& topology,
                           const Geometry& geometry,
                           const CoordinateBasis& basis) {
  const int order = basis.order();
  SparseMatrix system;
  system.rows = order * (topology.body_count() - 1);
  system.columns = topology.action_count();
  for (const CouplingTopology& coupling : topology.couplings) {
    for (int a = coupling.first_action; a < coupling.first_action + coupling.action_count; ++a) {
      const Vec6 screw = geometry.actions[static_cast<std::size_t>(a)].coordinates();
      if (coupling.head.value > 0) {
        const int row = order * (coupling.head.value - 1);
        add_screw(screw, basis, 1.0, {.row = row, .column = a, .value = 0.0}, system);
      }
      if (coupling.tail.value > 0) {
        const int row = order * (coupling.tail.value - 1);
        add_screw(screw, basis, -1.0, {.row = row, .column = a, .value = 0.0}, system);
      }
    }
  }
  return system;
}

}  // namespace kinestat
