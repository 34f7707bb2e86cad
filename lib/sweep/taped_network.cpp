#include "sweep/taped_network.hpp"

#include <algorithm>

#include "network/node_system.hpp"

namespace kinestat {

namespace {

double coordinate(const Geometry& geometry, NetworkSide side, std::size_t screw, int i) {
  return side == NetworkSide::motion ? geometry.motions[screw].coordinates()[i]
                                     : geometry.actions[screw].coordinates()[i];
}

class NetworkRecorder {
 public:
  NetworkRecorder(const TapedSystem& system, LaneRecorder& recorder)
      : system_(system), topology_(*system.topology), recorder_(recorder) {}

  std::optional<std::vector<TapeNumber>> run() {
    if (!system_.basis->is_made_of_coordinates()) {
      return std::nullopt;
    }
    system_.side == NetworkSide::motion ? add_velocities() : add_actions();
    std::vector<TapedUnknown> known;
    for (std::size_t i = 0; i < system_.primaries.size(); ++i) {
      const int index = system_.primaries[i].index;
      const TapeNumber unit = recorder_.constant(unit_of(index));
      known.push_back(
          {.column = column_of(index), .value = recorder_.divide(system_.known[i], unit)});
    }
    std::vector<int> columns;
    for (const int one : system_.wanted) {
      columns.push_back(column_of(one));
    }
    auto unknowns = record_elimination(matrix_, known, columns, recorder_);
    for (std::size_t i = 0; unknowns && i < columns.size(); ++i) {
      TapeNumber& one = (*unknowns)[i];
      one = recorder_.multiply(one, recorder_.constant(unit_of(system_.wanted[i])));
    }
    return unknowns;
  }

 private:
  int column_of(int index) const {
    return system_.side == NetworkSide::motion ? velocity_column(topology_, *system_.basis, index)
                                               : index;
  }

  double unit_of(int index) const {
    return system_.side == NetworkSide::motion ? rate_unit(topology_, *system_.basis, index)
                                               : action_unit(topology_, *system_.basis, index);
  }

  // As velocity_system has it.
  void add_velocities() {
    const int order = system_.basis->order();
    matrix_.rows = order * topology_.coupling_count();
    matrix_.columns = order * (topology_.body_count() - 1) + topology_.freedom_count();
    for (int e = 0; e < topology_.coupling_count(); ++e) {
      const CouplingTopology& coupling = topology_.couplings[static_cast<std::size_t>(e)];
      for (int i = 0; i < order; ++i) {
        add_constant(order * e + i, coupling.head, i, 1.0);
        add_constant(order * e + i, coupling.tail, i, -1.0);
      }
      for (int f = coupling.first_freedom; f < coupling.first_freedom + coupling.freedom_count;
           ++f) {
        add_screw(f, order * e, -unit_of(f));
      }
    }
  }

  void add_constant(int row, BodyId body, int i, double value) {
    if (body.value > 0) {
      matrix_.entries.push_back({.row = row,
                                 .column = system_.basis->order() * (body.value - 1) + i,
                                 .value = recorder_.constant(value)});
    }
  }

  // As action_system has it.
  void add_actions() {
    const int order = system_.basis->order();
    matrix_.rows = order * (topology_.body_count() - 1);
    matrix_.columns = topology_.action_count();
    for (const CouplingTopology& coupling : topology_.couplings) {
      for (int a = coupling.first_action; a < coupling.first_action + coupling.action_count; ++a) {
        if (coupling.head.value > 0) {
          add_screw(a, order * (coupling.head.value - 1), unit_of(a));
        }
        if (coupling.tail.value > 0) {
          add_screw(a, order * (coupling.tail.value - 1), -unit_of(a));
        }
      }
    }
  }

  bool is_zero_throughout(std::size_t screw, int i) const {
    const TapeNumber number = system_.screws[screw][static_cast<std::size_t>(i)];
    return recorder_.value(number) == 0.0 &&
           (recorder_.is_constant(number) ||
            std::ranges::all_of(system_.samples, [&](const Geometry& one) {
              return coordinate(one, system_.side, screw, i) == 0.0;
            }));
  }

  void add_screw(int index, int first_row, double factor) {
    const CoordinateBasis& basis = *system_.basis;
    const auto screw = static_cast<std::size_t>(index);
    int row = first_row;
    for (int i = 0; i < 6; ++i) {
      const bool is_in_basis = std::ranges::find(basis.coordinates, i) != basis.coordinates.end();
      const TapeNumber number = system_.screws[screw][static_cast<std::size_t>(i)];
      if (!is_in_basis || is_zero_throughout(screw, i)) {
        recorder_.demand_at_most(number, recorder_.constant(0.0));
      } else {
        const TapeNumber factor_in_units = recorder_.constant(factor / basis.unit[i]);
        matrix_.entries.push_back({.row = row,
                                   .column = column_of(index),
                                   .value = recorder_.multiply(number, factor_in_units)});
      }
      row += is_in_basis ? 1 : 0;
    }
  }

  const TapedSystem& system_;
  const Topology& topology_;
  LaneRecorder& recorder_;
  TapedMatrix matrix_;
};

}  // namespace

std::optional<std::vector<TapeNumber>> record_network(const TapedSystem& system,
                                                      LaneRecorder& recorder) {
  return NetworkRecorder(system, recorder).run();
}

}  // namespace kinestat
