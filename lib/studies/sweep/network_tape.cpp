#include "studies/sweep/network_tape.hpp"

#include <algorithm>

#include "network/node_layout.hpp"

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

  auto screw_adder() {
    return [this](int index, int first, int column, double factor) {
      add_screw(index, first, column, factor);
    };
  }

  void add_velocities() {
    resize(velocity_system_size(topology_, *system_.basis));
    lay_velocity_system(
        topology_,
        *system_.basis,
        [&](int row, int column, double value) {
          matrix_.entries.push_back(
              {.row = row, .column = column, .value = recorder_.constant(value)});
        },
        screw_adder());
  }

  void add_actions() {
    resize(action_system_size(topology_, *system_.basis));
    lay_action_system(topology_, *system_.basis, screw_adder());
  }

  void resize(const SystemSize& size) {
    matrix_.rows = size.rows;
    matrix_.columns = size.columns;
  }

  bool is_zero_throughout(std::size_t screw, int i) const {
    const TapeNumber number = system_.screws[screw][static_cast<std::size_t>(i)];
    return recorder_.value(number) == 0.0 &&
           (recorder_.is_constant(number) ||
            std::ranges::all_of(system_.samples, [&](const Geometry& one) {
              return coordinate(one, system_.side, screw, i) == 0.0;
            }));
  }

  void add_screw(int index, int first_row, int column, double factor) {
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
        matrix_.entries.push_back(
            {.row = row, .column = column, .value = recorder_.multiply(number, factor_in_units)});
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
