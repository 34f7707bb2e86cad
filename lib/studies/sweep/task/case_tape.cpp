#include "studies/sweep/task/case_tape.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "mechanism/label_kind.hpp"
#include "network/bases.hpp"
#include "statics/one_sided_action.hpp"
#include "studies/sweep/network_tape.hpp"
#include "studies/sweep/task/internal/limit_tape.hpp"
#include "studies/sweep/task/state_solver.hpp"
#include "studies/sweep/task/sweep_task.hpp"

namespace kinestat {

namespace {

class CaseRecorder {
 public:
  CaseRecorder(const SweepTask& task,
               std::size_t place,
               const SweptNumbers& numbers,
               SweepNotes& notes)
      : task_(task),
        place_(place),
        topology_(task.mechanism.topology),
        numbers_(numbers),
        notes_(notes) {}

  // False where no tape can be made.
  bool record(const CaseAnalysis& one) {
    const Case& which = one.which;
    taped_.known = largest_known(task_, which);
    const TapedPrimaries primaries = record_primaries(which);
    std::optional<TapedSide> motion;
    std::optional<TapedSide> action;
    Side motions(*this, NetworkSide::motion, which.motions, primaries.motions);
    Side actions(*this, NetworkSide::action, which.actions, primaries.actions, one.coast_flanks);
    if (one.motion) {
      motion = motions.record();
    }
    if (one.action) {
      action = actions.record();
    }
    if (motion.has_value() != one.motion.has_value() ||
        action.has_value() != one.action.has_value()) {
      return false;
    }
    if (action) {
      demand_flanks(one.coast_flanks, *action);
    }
    if (asks_power(task_.columns) && one.power &&
        !add_power({.solved = one,
                    .motion = *motion,
                    .action = *action,
                    .equilibrium = actions.system(),
                    .shares = numbers_.shares})) {
      return false;
    }
    if (motion && !add_limit_use({.motion = *motion,
                                  .action = action ? &*action : nullptr,
                                  .lossy_action = lossy_action_ ? &*lossy_action_ : nullptr})) {
      return false;
    }
    if (motion) {
      add_columns(NetworkSide::motion, *motion, SweepColumnKind::rate);
    }
    if (action) {
      add_columns(NetworkSide::action, *action, SweepColumnKind::action);
      // Without lossy meshes the actions with losses are those without.
      if (task_.mechanism.lossy_meshes.empty()) {
        add_columns(NetworkSide::action, *action, SweepColumnKind::lossy_action);
      }
      for (const int one_sided : one_sided_actions()) {
        taped_.one_sided.push_back(notes_.add_output(action->number(one_sided)));
      }
    }
    const bool asks_ratios = asks(task_.columns, SweepColumnKind::ratio) ||
                             asks(task_.columns, SweepColumnKind::step) ||
                             asks(task_.columns, SweepColumnKind::torque_ratio);
    taped_.has_ratios = asks_ratios && motion && !which.inputs.empty() && which.outputs.size() == 1;
    if (motion && (taped_.has_ratios || task_.gears[place_])) {
      taped_.input_rates = add_ends(NetworkSide::motion, *motion, which.inputs);
      taped_.output_rates = add_ends(NetworkSide::motion, *motion, which.outputs);
    }
    if (action && taped_.has_ratios) {
      taped_.input_actions = add_ends(NetworkSide::action, *action, which.inputs);
      taped_.output_actions = add_ends(NetworkSide::action, *action, which.outputs);
    }
    if (taped_.has_ratios) {
      add_ratios(which);
    }
    return true;
  }

  CaseTape take() { return std::move(taped_); }

 private:
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
    const bool is_motion = side == NetworkSide::motion;
    std::vector<int> wanted = is_motion ? std::vector<int>() : one_sided_actions();
    for (const OtherFlankOf<double>& flank : task_.mechanism.geometry.other_flanks) {
      if (!is_motion) {
        wanted.push_back(flank.action);
      }
    }
    for (const SweepColumn& column : task_.columns) {
      const bool is_action =
          column.kind == SweepColumnKind::action || column.kind == SweepColumnKind::lossy_action;
      if (is_motion ? column.kind == SweepColumnKind::rate : is_action) {
        wanted.push_back(column.index);
      }
    }
    if (asks_power(task_.columns)) {
      std::ranges::copy(is_motion ? actuator_freedoms() : actions_with_power(task_),
                        std::back_inserter(wanted));
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

  std::vector<int> actuator_freedoms() const {
    std::vector<int> freedoms;
    for (const ActuatorTopology& actuator : topology_.actuators) {
      freedoms.push_back(actuator.freedom);
    }
    return freedoms;
  }

  // By formulas, where states are not bound as a whole; empty places are inputs.
  TapedPrimaries record_primaries(const Case& which) {
    const std::size_t index = task_.chosen[place_];
    if (numbers_.rebinder != nullptr) {
      return numbers_.rebinder->record_primaries(index, which, notes_.slots, notes_.recorder);
    }
    const auto kept = [&](SweepInput::From from, const std::vector<Primary>& primaries) {
      std::vector<std::optional<TapeNumber>> values(primaries.size());
      for (std::size_t p = 0; p < primaries.size(); ++p) {
        if (!numbers_.bound->moves({.from = from, .index = index, .part = p, .dimension = {}})) {
          values[p] = notes_.recorder.constant(primaries[p].value);
        }
      }
      return values;
    };
    return {.motions = kept(SweepInput::From::primary_motion, which.motions),
            .actions = kept(SweepInput::From::primary_action, which.actions)};
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

  // The equations of one side of the case.
  class Side {
   public:
    Side(CaseRecorder& recorder,
         NetworkSide side,
         const std::vector<Primary>& primaries,
         const std::vector<std::optional<TapeNumber>>& values,
         const std::vector<int>& coast_flanks = {})
        : recorder_(recorder), side_(side), primaries_(primaries), values_(values) {
      const SweptNumbers& numbers = recorder.numbers_;
      screws_ = side == NetworkSide::motion ? numbers.screws->motions : numbers.screws->actions;
      geometry_ = recorder.task_.mechanism.geometry;
      samples_.assign(numbers.samples.begin(), numbers.samples.end());
      turn(coast_flanks);
    }

    std::optional<TapedSide> record() {
      const Mechanism& mechanism = recorder_.task_.mechanism;
      const bool is_motion = side_ == NetworkSide::motion;
      known_ = recorder_.known_of(side_, primaries_, values_);
      wanted_ = recorder_.wanted_of(side_);
      basis_ = is_motion ? motion_basis(geometry_, mechanism.kinematic_order)
                         : action_basis(geometry_, mechanism.static_order);
      auto network = record_network(system(), recorder_.notes_.recorder);
      return network ? std::optional(TapedSide{.wanted = wanted_, .network = *std::move(network)})
                     : std::nullopt;
    }

    /// Once it was recorded; the side must outlive it.
    TapedSystem system() const {
      const bool is_motion = side_ == NetworkSide::motion;
      return {.side = side_,
              .topology = &recorder_.topology_,
              .basis = &basis_,
              .screws = screws_,
              .samples = samples_,
              .primaries = primaries_,
              .known = known_,
              .wanted = wanted_,
              .wants_bodies = is_motion && asks_power(recorder_.task_.columns)};
    }

   private:
    // Teeth press with these other flanks.
    void turn(const std::vector<int>& coast_flanks) {
      for (const int i : coast_flanks) {
        const auto flank = static_cast<std::size_t>(i);
        screws_[static_cast<std::size_t>(geometry_.other_flanks[flank].action)] =
            recorder_.numbers_.screws->flanks[flank];
      }
      load_coast_flanks(coast_flanks, geometry_);
      for (Geometry& sample : samples_) {
        load_coast_flanks(coast_flanks, sample);
      }
    }

    CaseRecorder& recorder_;
    NetworkSide side_;
    std::vector<TapedScrew> screws_;
    Geometry geometry_;
    std::vector<Geometry> samples_;
    const std::vector<Primary>& primaries_;
    const std::vector<std::optional<TapeNumber>>& values_;
    std::vector<TapeNumber> known_;
    std::vector<int> wanted_;
    CoordinateBasis basis_;
  };

  // That the same teeth press with their coast flanks: those whose force is negative.
  void demand_flanks(const std::vector<int>& coast_flanks, const TapedSide& action) {
    LaneRecorder& recorder = notes_.recorder;
    const TapeNumber zero = recorder.constant(0.0);
    const auto& flanks = task_.mechanism.geometry.other_flanks;
    for (std::size_t i = 0; i < flanks.size(); ++i) {
      const TapeNumber force = action.number(flanks[i].action);
      const bool is_coast =
          std::ranges::find(coast_flanks, static_cast<int>(i)) != coast_flanks.end();
      recorder.demand_at_most(
          is_coast ? recorder.larger(force, zero) : recorder.smaller(force, zero), zero);
    }
  }

  bool add_power(const TapedCase& taped) {
    auto power = numbers_.keeps_axes ? note_power(task_, taped, notes_) : std::nullopt;
    if (!power) {
      return false;
    }
    taped_.power = std::move(power->power);
    lossy_action_ = std::move(power->action);
    if (lossy_action_) {
      add_columns(NetworkSide::action, *lossy_action_, SweepColumnKind::lossy_action);
    }
    return true;
  }

  // Of a gear.
  bool add_limit_use(const TapedGear& gear) {
    if (!task_.gears[place_] || !asks(task_.columns, SweepColumnKind::limit_use)) {
      return true;
    }
    const auto use =
        numbers_.keeps_axes ? record_limit_use(task_, gear, notes_.recorder) : std::nullopt;
    for (std::size_t q = 0; use && q < task_.columns.size(); ++q) {
      if (task_.columns[q].kind == SweepColumnKind::limit_use) {
        taped_.columns.push_back({.column = q, .cell = notes_.add_output(*use)});
      }
    }
    return use.has_value();
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

  void add_columns(NetworkSide side, const TapedSide& taped, SweepColumnKind kind) {
    for (std::size_t q = 0; q < task_.columns.size(); ++q) {
      const SweepColumn& column = task_.columns[q];
      if (column.kind == kind) {
        const TapeNumber number = in_unit(taped.number(column.index), kind_of(side, column.index));
        taped_.columns.push_back({.column = q, .cell = notes_.add_output(number)});
      }
    }
  }

  std::vector<std::size_t> add_ends(NetworkSide side,
                                    const TapedSide& taped,
                                    const std::vector<int>& actuators) {
    std::vector<std::size_t> outputs;
    for (const int actuator : actuators) {
      outputs.push_back(notes_.add_output(taped.number(index_of(side, actuator))));
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
  const SweptNumbers& numbers_;
  SweepNotes& notes_;
  CaseTape taped_;
  std::optional<TapedSide> lossy_action_;  // where meshes lose any
};

void find_cells(const LaneTape& tape, LossTape& losses) {
  for (auto* powers : {&losses.actuators, &losses.lossless}) {
    for (std::size_t& one : *powers) {
      one = tape.output_cell(one);
    }
  }
  losses.imbalance = tape.output_cell(losses.imbalance);
  if (losses.absolute) {
    losses.absolute = tape.output_cell(*losses.absolute);
  }
}

void find_cells(const LaneTape& tape, PowerTape& power) {
  if (power.losses) {
    find_cells(tape, *power.losses);
  }
  if (power.largest) {
    power.largest = tape.output_cell(*power.largest);
    power.input = tape.output_cell(power.input);
  }
}

}  // namespace

std::optional<CaseTape> note_case(const SweepTask& task,
                                  std::size_t place,
                                  const CaseAnalysis& solved,
                                  const SweptNumbers& numbers,
                                  SweepNotes& notes) {
  CaseRecorder recorder(task, place, numbers, notes);
  return recorder.record(solved) ? std::optional(recorder.take()) : std::nullopt;
}

void find_cells(const LaneTape& tape, CaseTape& taped) {
  for (auto* columns : {&taped.columns, &taped.ratios}) {
    for (TapedColumn& one : *columns) {
      one.cell = tape.output_cell(one.cell);
    }
  }
  if (taped.power) {
    find_cells(tape, *taped.power);
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
