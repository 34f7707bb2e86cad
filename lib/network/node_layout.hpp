// The places of the screws in the rows and columns of the node systems, whatever their numbers are.
#pragma once

#include "mechanism/topology.hpp"
#include "network/node_system.hpp"
#include "screw/coordinate_basis.hpp"

namespace kinestat {

struct SystemSize {
  int rows = 0;
  int columns = 0;
};

inline SystemSize velocity_system_size(const Topology& topology, const CoordinateBasis& basis) {
  return {.rows = basis.order() * topology.coupling_count(),
          .columns = velocity_column(topology, basis, topology.freedom_count())};
}

inline SystemSize action_system_size(const Topology& topology, const CoordinateBasis& basis) {
  return {.rows = basis.order() * (topology.body_count() - 1), .columns = topology.action_count()};
}

/// Lists the entries of velocity_system: calls add_one(row, column, value) for each coordinate of
/// the twist of a body, and add_screw(freedom, first row, column, factor) for the column of a
/// freedom in the rows of its coupling.
template <class AddOne, class AddScrew>
void lay_velocity_system(const Topology& topology,
                         const CoordinateBasis& basis,
                         const AddOne& add_one,
                         const AddScrew& add_screw) {
  const int order = basis.order();
  for (int e = 0; e < topology.coupling_count(); ++e) {
    const CouplingTopology& coupling = topology.couplings[static_cast<std::size_t>(e)];
    const auto add_body = [&](BodyId body, int i, double sign) {
      if (body.value > 0) {
        add_one(order * e + i, order * (body.value - 1) + i, sign);
      }
    };
    for (int i = 0; i < order; ++i) {
      add_body(coupling.head, i, 1.0);
      add_body(coupling.tail, i, -1.0);
    }
    for (int f = coupling.first_freedom; f < coupling.first_freedom + coupling.freedom_count; ++f) {
      add_screw(f, order * e, velocity_column(topology, basis, f), -rate_unit(topology, basis, f));
    }
  }
}

/// Lists the entries of action_system: calls add_screw(action, first row, column, factor) for each
/// of the two bodies on which an action acts, except the ground.
template <class AddScrew>
void lay_action_system(const Topology& topology,
                       const CoordinateBasis& basis,
                       const AddScrew& add_screw) {
  const int order = basis.order();
  for (const CouplingTopology& coupling : topology.couplings) {
    for (int a = coupling.first_action; a < coupling.first_action + coupling.action_count; ++a) {
      const double unit = action_unit(topology, basis, a);
      if (coupling.head.value > 0) {
        add_screw(a, order * (coupling.head.value - 1), a, unit);
      }
      if (coupling.tail.value > 0) {
        add_screw(a, order * (coupling.tail.value - 1), a, -unit);
      }
    }
  }
}

}  // namespace kinestat
