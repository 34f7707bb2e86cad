#include "sweep/network_tape.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "network/node_system.hpp"

namespace kinestat {

namespace {

double coordinate(const Geometry& geometry, NetworkSide side, int screw, int i) {
  const auto s = static_cast<std::size_t>(screw);
  return side == NetworkSide::motion ? geometry.motions[s].coordinates()[i]
                                     : geometry.actions[s].coordinates()[i];
}

}  // namespace

class NetworkTapeRecorder {
 public:
  explicit NetworkTapeRecorder(const TapedSystem& system)
      : system_(system), topology_(system.mechanism->topology) {}

  std::optional<NetworkTape> run() {
    if (!system_.basis->is_made_of_coordinates()) {
      return std::nullopt;
    }
    system_.side == NetworkSide::motion ? add_velocities() : add_actions();
    std::vector<int> last;
    std::vector<double> units;
    for (const Primary& primary : system_.primaries) {
      last.push_back(column_of(primary.index));
      units.push_back(unit_of(primary.index));
    }
    std::vector<int> columns;
    std::vector<NetworkTape::Output> outputs;
    for (const int one : system_.wanted) {
      columns.push_back(column_of(one));
      outputs.push_back({.column = column_of(one), .unit = unit_of(one)});
    }
    auto tape = EliminationTape::record(matrix_, varies_, last, columns);
    if (!tape) {
      return std::nullopt;
    }
    NetworkTape result(system_.side, *std::move(tape));
    result.varying_ = std::move(varying_);
    result.zeros_ = std::move(zeros_);
    result.known_units_ = std::move(units);
    result.outputs_ = std::move(outputs);
    return result;
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
        add_screw(f, order * e, -unit_of(f), (*system_.moves)[static_cast<std::size_t>(e)]);
      }
    }
  }

  void add_constant(int row, BodyId body, int i, double value) {
    if (body.value > 0) {
      matrix_.add(row, system_.basis->order() * (body.value - 1) + i, value);
      varies_.push_back(false);
    }
  }

  // As action_system has it.
  void add_actions() {
    const int order = system_.basis->order();
    matrix_.rows = order * (topology_.body_count() - 1);
    matrix_.columns = topology_.action_count();
    for (std::size_t e = 0; e < topology_.couplings.size(); ++e) {
      const CouplingTopology& coupling = topology_.couplings[e];
      for (int a = coupling.first_action; a < coupling.first_action + coupling.action_count; ++a) {
        if (coupling.head.value > 0) {
          add_screw(a, order * (coupling.head.value - 1), unit_of(a), (*system_.moves)[e]);
        }
        if (coupling.tail.value > 0) {
          add_screw(a, order * (coupling.tail.value - 1), -unit_of(a), (*system_.moves)[e]);
        }
      }
    }
  }

  bool is_zero_throughout(int screw, int i) const {
    const auto is_zero = [&](const Geometry& one) {
      return coordinate(one, system_.side, screw, i) == 0.0;
    };
    return is_zero(system_.mechanism->geometry) && std::ranges::all_of(system_.samples, is_zero);
  }

  void add_screw(int screw, int first_row, double factor, bool moves) {
    const CoordinateBasis& basis = *system_.basis;
    int row = first_row;
    for (int i = 0; i < 6; ++i) {
      const bool is_in_basis = std::ranges::find(basis.coordinates, i) != basis.coordinates.end();
      const bool is_zero = is_zero_throughout(screw, i);
      const NetworkTape::Slot slot{.screw = screw,
                                   .coordinate = i,
                                   .entry = matrix_.entries.size(),
                                   .factor = factor,
                                   .unit = basis.unit[i]};
      if (is_in_basis && !is_zero) {
        const double value = coordinate(system_.mechanism->geometry, system_.side, screw, i);
        matrix_.entries.push_back(
            {.row = row, .column = column_of(screw), .value = factor * value / basis.unit[i]});
        varies_.push_back(moves);
      }
      if (moves) {
        (is_in_basis && !is_zero ? varying_ : zeros_).push_back(slot);
      }
      row += is_in_basis ? 1 : 0;
    }
  }

  const TapedSystem& system_;
  const Topology& topology_;
  SparseMatrix matrix_;
  std::vector<bool> varies_;
  std::vector<NetworkTape::Slot> varying_;
  std::vector<NetworkTape::Slot> zeros_;
};

std::optional<NetworkTape> NetworkTape::record(const TapedSystem& system) {
  return NetworkTapeRecorder(system).run();
}

bool NetworkTape::eliminate(const Geometry& geometry, EliminationTape::Workspace& workspace) const {
  for (const Slot& slot : zeros_) {
    if (coordinate(geometry, side_, slot.screw, slot.coordinate) != 0.0) {
      return false;
    }
  }
  tape_.reset(workspace);
  for (const Slot& slot : varying_) {
    tape_.set(workspace,
              slot.entry,
              slot.factor * coordinate(geometry, side_, slot.screw, slot.coordinate) / slot.unit);
  }
  return tape_.eliminate(workspace);
}

bool NetworkTape::solve(std::span<const Primary> primaries,
                        EliminationTape::Workspace& workspace,
                        std::vector<double>& known,
                        std::vector<double>& wanted) const {
  known.resize(primaries.size());
  for (std::size_t i = 0; i < primaries.size(); ++i) {
    known[i] = primaries[i].value / known_units_[i];
  }
  tape_.solve(workspace, known);
  wanted.resize(outputs_.size());
  bool is_finite = true;
  for (std::size_t i = 0; i < outputs_.size(); ++i) {
    wanted[i] = outputs_[i].unit * tape_.unknown(workspace, outputs_[i].column);
    is_finite = is_finite && std::isfinite(wanted[i]);
  }
  return is_finite;
}

}  // namespace kinestat
