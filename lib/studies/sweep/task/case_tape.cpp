#include "studies/sweep/task/case_tape.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "mechanism/label_kind.hpp"
#include "network/bases.hpp"
#include "statics/one_sided_action.hpp"
#include "studies/sweep/network_tape.hpp"
#include "studies/sweep/task/sweep_task.hpp"

namespace kinestat {

namespace {

// The magnitudes of one case that quantities, or the status of a row, need [SI].
struct TapedSide {
  NetworkSide side = NetworkSide::motion;
  std::vector<int> wanted;  ///< freedoms or actions, ascending
  std::vector<TapeNumber> numbers;

  TapeNumber number(int index) const {
    return numbers[static_cast<std::size_t>(std::ranges::lower_bound(wanted, index) -
                                            wanted.begin())];
  }
};

class CaseRecorder {
 public:
  CaseRecorder(const SweepTask& task,
               std::size_t place,
               const SweptGeometry& geometry,
               SweepNotes& notes)
      : task_(task),
        place_(place),
        topology_(task.mechanism.topology),
        geometry_(geometry),
        notes_(notes) {}

  // False where no tape can be made.
  bool record(const CaseAnalysis& one) {
    const Case& which = one.which;
    const TapedPrimaries primaries = geometry_.rebinder->record_primaries(
        task_.chosen[place_], which, notes_.slots, notes_.recorder);
    std::optional<TapedSide> motion;
    std::optional<TapedSide> action;
    if (one.motion) {
      motion = record_side(NetworkSide::motion, which.motions, primaries.motions);
    }
    if (one.action) {
      action = record_side(NetworkSide::action, which.actions, primaries.actions);
    }
    if (motion.has_value() != one.motion.has_value() ||
        action.has_value() != one.action.has_value()) {
      return false;
    }
    if (motion) {
      add_columns(*motion, SweepColumnKind::rate);
    }
    if (action) {
      add_columns(*action, SweepColumnKind::action);
      for (const int one_sided : one_sided_actions()) {
        taped_.one_sided.push_back(notes_.add_output(action->number(one_sided)));
      }
    }
    const bool asks_ratios = asks(SweepColumnKind::ratio) || asks(SweepColumnKind::step) ||
                             asks(SweepColumnKind::torque_ratio);
    taped_.has_ratios = asks_ratios && motion && !which.inputs.empty() && which.outputs.size() == 1;
    if (motion && (taped_.has_ratios || task_.gears[place_])) {
      taped_.input_rates = add_ends(*motion, which.inputs);
      taped_.output_rates = add_ends(*motion, which.outputs);
    }
    if (action && taped_.has_ratios) {
      taped_.input_actions = add_ends(*action, which.inputs);
      taped_.output_actions = add_ends(*action, which.outputs);
    }
    if (taped_.has_ratios) {
      add_ratios(which);
    }
    return true;
  }

  CaseTape take() { return std::move(taped_); }

 private:
  bool asks(SweepColumnKind kind) const {
    return std::ranges::find(task_.columns, kind, &SweepColumn::kind) != task_.columns.end();
  }

  int index_of(NetworkSide side, int actuator) const {
    const ActuatorTopology& one = topology_.actuators[static_cast<std::size_t>(actuator)];
    return side == NetworkSide::motion ? one.freedom : one.action;
  }

  std::vector<int> one_sided_actions() const {
    std::vector<int> actions = find_tensions(topology_);
    std::ranges::copy(find_contact_forces(topology_), std::back_inserter(actions));
    return actions;
  }

  std::vector<int> wanted_of(NetworkSide side) const {
    std::vector<int> wanted =
        side == NetworkSide::action ? one_sided_actions() : std::vector<int>();
    for (const SweepColumn& column : task_.columns) {
      if (column.kind ==
          (side == NetworkSide::motion ? SweepColumnKind::rate : SweepColumnKind::action)) {
        wanted.push_back(column.index);
      }
    }
    const Case& which = task_.cases[place_];
    for (const auto* ends : {&which.inputs, &which.outputs}) {
      for (const int actuator : *ends) {
        wanted.push_back(index_of(side, actuator));
      }
    }
    std::ranges::sort(wanted);
    wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
    return wanted;
  }

  std::vector<TapeNumber> known_of(NetworkSide side,
                                   const std::vector<Primary>& primaries,
                                   const std::vector<std::optional<TapeNumber>>& values) {
    std::vector<TapeNumber> known;
    for (std::size_t p = 0; p < values.size(); ++p) {
      const SweepInput input{.from = side == NetworkSide::motion ? SweepInput::From::primary_motion
                                                                 : SweepInput::From::primary_action,
                             .index = task_.chosen[place_],
                             .part = p,
                             .dimension = {}};
      known.push_back(values[p] ? *values[p] : notes_.take(input, primaries[p].value));
    }
    return known;
  }

  std::optional<TapedSide> record_side(NetworkSide side,
                                       const std::vector<Primary>& primaries,
                                       const std::vector<std::optional<TapeNumber>>& values) {
    const Mechanism& mechanism = task_.mechanism;
    const bool is_motion = side == NetworkSide::motion;
    const std::vector<TapeNumber> known = known_of(side, primaries, values);
    const CoordinateBasis basis = is_motion
                                      ? motion_basis(mechanism.geometry, mechanism.kinematic_order)
                                      : action_basis(mechanism.geometry, mechanism.static_order);
    const TapedScrews& screws = *geometry_.screws;
    TapedSide result{.side = side, .wanted = wanted_of(side), .numbers = {}};
    auto numbers = record_network({.side = side,
                                   .topology = &topology_,
                                   .basis = &basis,
                                   .screws = is_motion ? screws.motions : screws.actions,
                                   .samples = geometry_.samples,
                                   .primaries = primaries,
                                   .known = known,
                                   .wanted = result.wanted},
                                  notes_.recorder);
    if (!numbers) {
      return std::nullopt;
    }
    result.numbers = *std::move(numbers);
    return result;
  }

  bool turns(NetworkSide side, int index) const {
    const auto i = static_cast<std::size_t>(index);
    return side == NetworkSide::motion ? topology_.freedoms[i].is_rotation
                                       : topology_.actions[i].is_couple;
  }

  QuantityKind kind_of(NetworkSide side, int index) const {
    const bool is_turning = turns(side, index);
    return side == NetworkSide::motion ? rate_kind(is_turning) : action_kind(is_turning);
  }

  // As UnitScale::from_si.
  TapeNumber in_unit(TapeNumber number, QuantityKind kind) {
    const UnitScale& scale = task_.description.units.scale(kind);
    const UnitScale above{scale.numerator, 1.0, scale.pi_power};
    return scaled(number, scale.denominator, above.factor());
  }

  void add_columns(const TapedSide& side, SweepColumnKind kind) {
    for (std::size_t q = 0; q < task_.columns.size(); ++q) {
      const SweepColumn& column = task_.columns[q];
      if (column.kind == kind) {
        const TapeNumber number =
            in_unit(side.number(column.index), kind_of(side.side, column.index));
        taped_.columns.push_back({.column = q, .cell = notes_.add_output(number)});
      }
    }
  }

  std::vector<std::size_t> add_ends(const TapedSide& side, const std::vector<int>& actuators) {
    std::vector<std::size_t> outputs;
    for (const int actuator : actuators) {
      outputs.push_back(notes_.add_output(side.number(index_of(side.side, actuator))));
    }
    return outputs;
  }

  // Where a rotation drives a translation or the other way round; otherwise they cancel.
  void add_ratio_units(int in, int out) {
    const auto unit_of = [&](NetworkSide side, int actuator) {
      return task_.description.units.factor(kind_of(side, index_of(side, actuator)));
    };
    if (turns(NetworkSide::motion, index_of(NetworkSide::motion, in)) !=
        turns(NetworkSide::motion, index_of(NetworkSide::motion, out))) {
      taped_.ratio_unit = unit_of(NetworkSide::motion, out);
      taped_.ratio_per = unit_of(NetworkSide::motion, in);
      taped_.torque_ratio_unit = unit_of(NetworkSide::action, out);
      taped_.torque_ratio_per = unit_of(NetworkSide::action, in);
    }
  }

  // As find_ratios, and in the units of the file.
  void add_ratios(const Case& which) {
    add_ratio_units(which.inputs.front(), which.outputs.front());
    if (which.inputs.size() > 1) {
      return;
    }
    for (std::size_t q = 0; q < task_.columns.size(); ++q) {
      const SweepColumnKind kind = task_.columns[q].kind;
      if (kind == SweepColumnKind::ratio) {
        const TapeNumber ratio = quotient(taped_.input_rates, taped_.output_rates);
        add_ratio(q, scaled(ratio, taped_.ratio_unit, taped_.ratio_per));
      } else if (kind == SweepColumnKind::torque_ratio && !taped_.input_actions.empty()) {
        const TapeNumber ratio = quotient(taped_.input_actions, taped_.output_actions);
        add_ratio(q, scaled(ratio, taped_.torque_ratio_unit, taped_.torque_ratio_per));
      }
    }
  }

  void add_ratio(std::size_t column, TapeNumber ratio) {
    taped_.ratios.push_back({.column = column, .cell = notes_.add_output(ratio)});
  }

  TapeNumber quotient(const std::vector<std::size_t>& above,
                      const std::vector<std::size_t>& below) {
    return notes_.recorder.divide(notes_.outputs[above.front()], notes_.outputs[below.front()]);
  }

  TapeNumber scaled(TapeNumber number, double unit, double per) {
    LaneRecorder& recorder = notes_.recorder;
    return recorder.divide(recorder.multiply(number, recorder.constant(unit)),
                           recorder.constant(per));
  }

  const SweepTask& task_;
  std::size_t place_;
  const Topology& topology_;
  const SweptGeometry& geometry_;
  SweepNotes& notes_;
  CaseTape taped_;
};

}  // namespace

std::optional<CaseTape> note_case(const SweepTask& task,
                                  std::size_t place,
                                  const CaseAnalysis& solved,
                                  const SweptGeometry& geometry,
                                  SweepNotes& notes) {
  CaseRecorder recorder(task, place, geometry, notes);
  return recorder.record(solved) ? std::optional(recorder.take()) : std::nullopt;
}

void find_cells(const LaneTape& tape, CaseTape& taped) {
  for (auto* columns : {&taped.columns, &taped.ratios}) {
    for (TapedColumn& one : *columns) {
      one.cell = tape.output_cell(one.cell);
    }
  }
  for (auto* ends : {&taped.input_rates,
                     &taped.output_rates,
                     &taped.input_actions,
                     &taped.output_actions,
                     &taped.one_sided}) {
    for (std::size_t& one : *ends) {
      one = tape.output_cell(one);
    }
  }
}

}  // namespace kinestat
