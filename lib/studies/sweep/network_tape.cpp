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

  std::optional<TapedNetwork> run() {
    if (!system_.basis->is_made_of_coordinates()) {
      return std::nullopt;
    }
    is_motion() ? add_velocities() : add_actions();
    if (!std::ranges::all_of(system_.couples,
                             [this](const TapedCouple& one) { return add_couple(one); })) {
      return std::nullopt;
    }
    std::vector<TapedUnknown> known;
    for (std::size_t i = 0; i < system_.primaries.size(); ++i) {
      const int index = system_.primaries[i].index;
      const TapeNumber unit = recorder_.constant(unit_of(index));
      known.push_back(
          {.column = column_of(index), .value = recorder_.divide(system_.known[i], unit)});
    }
    const std::vector<Asked> asked = find_asked();
    std::vector<int> columns;
    for (const Asked& one : asked) {
      columns.push_back(one.column);
    }
    auto unknowns = record_elimination(matrix_, known, columns, recorder_);
    for (std::size_t i = 0; unknowns && i < asked.size(); ++i) {
      TapeNumber& one = (*unknowns)[i];
      one = recorder_.multiply(one, recorder_.constant(asked[i].unit));
    }
    return unknowns ? std::optional(sorted(*unknowns)) : std::nullopt;
  }

 private:
  // An unknown with the size of its unit [SI].
  struct Asked {
    int column = 0;
    double unit = 1.0;
  };

  bool is_motion() const { return system_.side == NetworkSide::motion; }

  int column_of(int index) const {
    return is_motion() ? velocity_column(topology_, *system_.basis, index) : index;
  }

  double unit_of(int index) const {
    return is_motion() ? rate_unit(topology_, *system_.basis, index)
                       : action_unit(topology_, *system_.basis, index);
  }

  double unit_of_coordinate(int coordinate) const { return system_.basis->unit[coordinate]; }

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
        [&](int row, int column, double value) { add(row, column, recorder_.constant(value)); },
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

  void add(int row, int column, TapeNumber value) {
    matrix_.entries.push_back({.row = row, .column = column, .value = value});
  }

  // An unknown and an equation more; false where the basis does not hold the couple.
  bool add_couple(const TapedCouple& couple) {
    const CoordinateBasis& basis = *system_.basis;
    const auto at = std::ranges::find(basis.coordinates, couple.coordinate);
    if (at == basis.coordinates.end()) {
      return false;
    }
    const int column = matrix_.columns++;
    const int row = matrix_.rows++;
    const auto place = static_cast<int>(at - basis.coordinates.begin());
    const auto act_on = [&](BodyId body, double sign) {
      if (body.value > 0) {
        add(basis.order() * (body.value - 1) + place, column, recorder_.constant(sign));
      }
    };
    act_on(couple.head, 1.0);
    act_on(couple.tail, -1.0);
    const double unit = unit_of_coordinate(couple.coordinate);
    add(row, column, recorder_.multiply(couple.speed, recorder_.constant(unit)));
    for (const TapedCouple::Share& share : couple.shares) {
      const TapeNumber factor = recorder_.constant(unit_of(share.action));
      add(row, share.action, recorder_.multiply(share.per_action, factor));
    }
    return true;
  }

  std::vector<Asked> find_asked() const {
    std::vector<Asked> asked;
    for (const int one : system_.wanted) {
      asked.push_back({.column = column_of(one), .unit = unit_of(one)});
    }
    const int order = system_.basis->order();
    for (int body = 1; system_.wants_bodies && body < topology_.body_count(); ++body) {
      for (int i = 0; i < order; ++i) {
        const int coordinate = system_.basis->coordinates[static_cast<std::size_t>(i)];
        asked.push_back({.column = order * (body - 1) + i, .unit = unit_of_coordinate(coordinate)});
      }
    }
    const int first_couple = matrix_.columns - static_cast<int>(system_.couples.size());
    for (std::size_t i = 0; i < system_.couples.size(); ++i) {
      asked.push_back({.column = first_couple + static_cast<int>(i),
                       .unit = unit_of_coordinate(system_.couples[i].coordinate)});
    }
    return asked;
  }

  // From the order in which they were asked for.
  TapedNetwork sorted(const std::vector<TapeNumber>& unknowns) {
    TapedNetwork network;
    auto next = unknowns.begin();
    const auto take = [&](std::size_t count) {
      next += static_cast<std::ptrdiff_t>(count);
      return std::vector<TapeNumber>(next - static_cast<std::ptrdiff_t>(count), next);
    };
    network.wanted = take(system_.wanted.size());
    TapedScrew at_rest;
    at_rest.fill(recorder_.constant(0.0));
    for (int body = 0; system_.wants_bodies && body < topology_.body_count(); ++body) {
      network.bodies.push_back(at_rest);
      for (const int coordinate : system_.basis->coordinates) {
        if (body > 0) {
          network.bodies.back()[static_cast<std::size_t>(coordinate)] = *next++;
        }
      }
    }
    network.couples = take(system_.couples.size());
    return network;
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
        add(row, column, recorder_.multiply(number, factor_in_units));
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

std::optional<TapedNetwork> record_network(const TapedSystem& system, LaneRecorder& recorder) {
  return NetworkRecorder(system, recorder).run();
}

}  // namespace kinestat
