#include "run/internal/sweep_tapes.hpp"

#include <algorithm>
#include <utility>

#include "network/bases.hpp"
#include "run/internal/sweep_samples.hpp"
#include "run/internal/sweep_task.hpp"
#include "run/solve_cases.hpp"
#include "sweep/taped_network.hpp"

namespace kinestat {

namespace {

bool is_plain(const SweepTask& task, const CaseAnalysis& one) {
  const bool has_motion = !one.motion || one.motion->status == SolveStatus::solved;
  const bool has_action = !one.action || one.action->status == SolveStatus::solved;
  return has_motion && has_action && one.which.loads.empty() &&
         std::ranges::none_of(task.quantities, [](const SweepQuantity& quantity) {
           return needs_power(quantity.kind);
         });
}

// A tape keeps no torque of a freewheel. The class of a combination hangs on the speeds where there
// are several inputs, and those of the state are not at hand.
bool knows_gears(const SweepTask& task) {
  if (!task.shift) {
    return true;
  }
  const bool has_freewheels = std::ranges::any_of(
      task.shift->elements, [](const ShiftElement& element) { return element.one_way != 0; });
  const bool has_combinations =
      std::ranges::any_of(task.gears, [](const std::optional<SweptGear>& gear) {
        return gear && gear->state.state.kind != ShiftClass::gear;
      });
  return !has_freewheels && (task.shift->inputs.size() == 1 || !has_combinations);
}

// Records all cases of a task.
class SweepRecorder {
 public:
  SweepRecorder(const SweepTask& task,
                const Rebinder& rebinder,
                std::span<const SweepSample> samples)
      : task_(task), rebinder_(rebinder), topology_(task.mechanism.topology), samples_(samples) {
    for (const SweepSample& sample : samples) {
      geometries_.push_back(sample.geometry);
    }
    tapes_.emplace(SweepTapes{.rebinder = rebinder,
                              .tape = {},
                              .inputs = {},
                              .needs_geometry = false,
                              .needs_primaries = false,
                              .cases = {}});
    add_parameters();
  }

  // By formulas; false where the geometry moves otherwise, or not as it is bound.
  bool record_geometry(NearOrigin near) {
    auto screws = rebinder_.record_screws(near, task_.mechanism.geometry, slots_, recorder_);
    if (!screws) {
      return false;
    }
    screws_ = *std::move(screws);
    return moves_as_samples(near);
  }

  // From what is rebound for each state.
  void take_geometry() {
    tapes_->needs_geometry = true;
    const Geometry& geometry = task_.mechanism.geometry;
    for (std::size_t f = 0; f < geometry.motions.size(); ++f) {
      screws_.motions.push_back(take_screw(SweepInput::From::motion,
                                           f,
                                           geometry.motions[f].coordinates(),
                                           topology_.freedoms[f].coupling));
    }
    for (std::size_t a = 0; a < geometry.actions.size(); ++a) {
      screws_.actions.push_back(take_screw(SweepInput::From::action,
                                           a,
                                           geometry.actions[a].coordinates(),
                                           topology_.actions[a].coupling));
    }
  }

  std::optional<SweepTapes> record_cases() {
    const std::vector<CaseAnalysis> cases = solve_some_cases(task_.mechanism, task_.cases);
    for (std::size_t i = 0; i < cases.size(); ++i) {
      tapes_->cases.emplace_back();
      const bool is_taped = !task_.gears[i] || task_.gears[i]->state.state.kind == ShiftClass::gear;
      if (is_taped && (!is_plain(task_, cases[i]) || !record_case(i, cases[i]))) {
        return std::nullopt;
      }
    }
    tapes_->tape = recorder_.make_tape(outputs_);
    for (TapedCase& taped : tapes_->cases) {
      find_cells(taped);
    }
    return std::move(tapes_);
  }

 private:
  TapeNumber take(const SweepInput& input, double value, const TapeRange& range = {}) {
    tapes_->inputs.push_back(input);
    return recorder_.input(value, range);
  }

  // Those that are varied, and what follows from them: by its formula where that can be.
  void add_parameters() {
    const Slots& slots = task_.plan.slots();
    for (std::size_t i = 0; i < slots.values.size(); ++i) {
      slots_.emplace_back();
      if (slots.has_value[i]) {
        slots_.back() = {recorder_.constant(slots.values[i].value), slots.values[i].dimension};
      }
    }
    for (const SweepAxis& axis : task_.plan.axes()) {
      const auto [least, most] = axis.bounds();
      take_parameter(axis.parameter(), {least, most});
    }
    for (const DependentParameter& one : task_.plan.dependents()) {
      if (const auto quantity = record_quantity(one.value, slots_, recorder_)) {
        slots_[static_cast<std::size_t>(one.parameter)] = quantity;
      } else {
        take_parameter(one.parameter, {});
      }
    }
  }

  void take_parameter(int parameter, const TapeRange& range) {
    const auto i = static_cast<std::size_t>(parameter);
    slots_[i].reset();
    if (task_.plan.slots().has_value[i]) {
      const Quantity& value = task_.plan.slots().values[i];
      const SweepInput input{
          .from = SweepInput::From::parameter, .index = i, .part = 0, .dimension = value.dimension};
      slots_[i] = {take(input, value.value, range), value.dimension};
    }
  }

  TapedScrew take_screw(SweepInput::From from,
                        std::size_t index,
                        const Vec6& coordinates,
                        CouplingId coupling) {
    TapedScrew screw;
    for (std::size_t i = 0; i < screw.size(); ++i) {
      const double value = coordinates[static_cast<Eigen::Index>(i)];
      screw[i] = rebinder_.moves()[static_cast<std::size_t>(coupling.value)]
                     ? take({.from = from, .index = index, .part = i, .dimension = {}}, value)
                     : recorder_.constant(value);
    }
    return screw;
  }

  // A tape of the screws alone gives the bits that binding gives; a cheap test is no good where it
  // leaves out states.
  bool moves_as_samples(NearOrigin near) const {
    std::vector<TapeNumber> outputs;
    for (const auto* screws : {&screws_.motions, &screws_.actions}) {
      for (const TapedScrew& screw : *screws) {
        outputs.insert(outputs.end(), screw.begin(), screw.end());
      }
    }
    const LaneTape tape = recorder_.make_tape(outputs);
    LaneTape::Workspace workspace = tape.make_workspace(1);
    return std::ranges::all_of(samples_, [&](const SweepSample& sample) {
      for (std::size_t i = 0; i < tapes_->inputs.size(); ++i) {
        tape.set_input(workspace, i, 0, sample.slots.values[tapes_->inputs[i].index].value);
      }
      tape.play(workspace);
      return tape.is_met(workspace, 0) ? moves_as(sample.geometry, tape, workspace)
                                       : near == NearOrigin::by_all_points;
    });
  }

  static bool moves_as(const Geometry& geometry,
                       const LaneTape& tape,
                       const LaneTape::Workspace& workspace) {
    std::size_t output = 0;
    const auto is_same = [&](const auto& screw) {
      bool is_equal = true;
      for (const double coordinate : screw.coordinates()) {
        is_equal = tape.output(workspace, output++, 0) == coordinate && is_equal;
      }
      return is_equal;
    };
    return std::ranges::all_of(geometry.motions, is_same) &&
           std::ranges::all_of(geometry.actions, is_same);
  }

  // In place of the outputs themselves.
  void find_cells(TapedCase& taped) const {
    const LaneTape& tape = tapes_->tape;
    for (auto* columns : {&taped.columns, &taped.ratios}) {
      for (TapedColumn& one : *columns) {
        one.cell = tape.output_cell(one.cell);
      }
    }
    for (auto* ends :
         {&taped.input_rates, &taped.output_rates, &taped.input_actions, &taped.output_actions}) {
      for (std::size_t& one : *ends) {
        one = tape.output_cell(one);
      }
    }
  }

  std::size_t add_output(TapeNumber number) {
    outputs_.push_back(number);
    return outputs_.size() - 1;
  }

  // False where a tape is needed and none can be made.
  bool record_case(std::size_t i, const CaseAnalysis& one) {
    const TapedPrimaries primaries =
        rebinder_.record_primaries(task_.chosen[i], one.which, slots_, recorder_);
    TapedCase& taped = tapes_->cases.back();
    std::optional<Side> motion;
    std::optional<Side> action;
    if (one.motion) {
      motion = record_side(i, NetworkSide::motion, one.which.motions, primaries.motions);
    }
    if (one.action) {
      action = record_side(i, NetworkSide::action, one.which.actions, primaries.actions);
    }
    if (motion.has_value() != one.motion.has_value() ||
        action.has_value() != one.action.has_value()) {
      return false;
    }
    if (motion) {
      add_columns(*motion, SweepQuantityKind::rate, taped);
    }
    if (action) {
      add_columns(*action, SweepQuantityKind::action, taped);
    }
    const bool asks_ratios = asks(SweepQuantityKind::ratio) || asks(SweepQuantityKind::step) ||
                             asks(SweepQuantityKind::torque_ratio);
    taped.has_ratios =
        asks_ratios && motion && !one.which.inputs.empty() && one.which.outputs.size() == 1;
    if (motion && (taped.has_ratios || task_.gears[i])) {
      taped.input_rates = add_ends(*motion, one.which.inputs);
      taped.output_rates = add_ends(*motion, one.which.outputs);
    }
    if (action && taped.has_ratios) {
      taped.input_actions = add_ends(*action, one.which.inputs);
      taped.output_actions = add_ends(*action, one.which.outputs);
    }
    if (taped.has_ratios) {
      add_ratios(one.which, taped);
    }
    return true;
  }

  // The magnitudes of one case that quantities, or the status of a row, need [SI].
  struct Side {
    NetworkSide side = NetworkSide::motion;
    std::vector<int> wanted;  ///< freedoms or actions, ascending
    std::vector<TapeNumber> numbers;

    TapeNumber number(int index) const {
      return numbers[static_cast<std::size_t>(std::ranges::lower_bound(wanted, index) -
                                              wanted.begin())];
    }
  };

  bool asks(SweepQuantityKind kind) const {
    return std::ranges::find(task_.quantities, kind, &SweepQuantity::kind) !=
           task_.quantities.end();
  }

  int index_of(NetworkSide side, int actuator) const {
    const ActuatorTopology& one = topology_.actuators[static_cast<std::size_t>(actuator)];
    return side == NetworkSide::motion ? one.freedom : one.action;
  }

  std::vector<int> wanted_of(const Case& which, NetworkSide side) const {
    std::vector<int> wanted;
    for (const SweepQuantity& quantity : task_.quantities) {
      if (quantity.kind ==
          (side == NetworkSide::motion ? SweepQuantityKind::rate : SweepQuantityKind::action)) {
        wanted.push_back(quantity.index);
      }
    }
    for (const auto* ends : {&which.inputs, &which.outputs}) {
      for (const int actuator : *ends) {
        wanted.push_back(index_of(side, actuator));
      }
    }
    std::ranges::sort(wanted);
    wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
    return wanted;
  }

  std::optional<Side> record_side(std::size_t i,
                                  NetworkSide side,
                                  const std::vector<Primary>& primaries,
                                  const std::vector<std::optional<TapeNumber>>& values) {
    const Mechanism& mechanism = task_.mechanism;
    const bool is_motion = side == NetworkSide::motion;
    std::vector<TapeNumber> known;
    for (std::size_t p = 0; p < values.size(); ++p) {
      const SweepInput input{
          .from = is_motion ? SweepInput::From::primary_motion : SweepInput::From::primary_action,
          .index = task_.chosen[i],
          .part = p,
          .dimension = {}};
      tapes_->needs_primaries = tapes_->needs_primaries || !values[p];
      known.push_back(values[p] ? *values[p] : take(input, primaries[p].value));
    }
    const CoordinateBasis basis = is_motion
                                      ? motion_basis(mechanism.geometry, mechanism.kinematic_order)
                                      : action_basis(mechanism.geometry, mechanism.static_order);
    Side result{.side = side, .wanted = wanted_of(task_.cases[i], side), .numbers = {}};
    auto numbers = record_network({.side = side,
                                   .topology = &topology_,
                                   .basis = &basis,
                                   .screws = is_motion ? screws_.motions : screws_.actions,
                                   .samples = geometries_,
                                   .primaries = primaries,
                                   .known = known,
                                   .wanted = result.wanted},
                                  recorder_);
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
    if (side == NetworkSide::motion) {
      return turns(side, index) ? QuantityKind::angular_velocity : QuantityKind::velocity;
    }
    return turns(side, index) ? QuantityKind::moment : QuantityKind::force;
  }

  // As UnitScale::from_si.
  TapeNumber in_unit(TapeNumber number, QuantityKind kind) {
    const UnitScale& scale = task_.description.units.scale(kind);
    const UnitScale above{scale.numerator, 1.0, scale.pi_power};
    return recorder_.divide(recorder_.multiply(number, recorder_.constant(scale.denominator)),
                            recorder_.constant(above.factor()));
  }

  void add_columns(const Side& side, SweepQuantityKind kind, TapedCase& taped) {
    for (std::size_t q = 0; q < task_.quantities.size(); ++q) {
      const SweepQuantity& quantity = task_.quantities[q];
      if (quantity.kind == kind) {
        const TapeNumber number =
            in_unit(side.number(quantity.index), kind_of(side.side, quantity.index));
        taped.columns.push_back({.column = q, .cell = add_output(number)});
      }
    }
  }

  std::vector<std::size_t> add_ends(const Side& side, const std::vector<int>& actuators) {
    std::vector<std::size_t> outputs;
    for (const int actuator : actuators) {
      outputs.push_back(add_output(side.number(index_of(side.side, actuator))));
    }
    return outputs;
  }

  // As find_ratios, and in the units of the file.
  void add_ratios(const Case& which, TapedCase& taped) {
    const FileUnits& units = task_.description.units;
    const auto unit_of = [&](NetworkSide side, int actuator) {
      return units.factor(kind_of(side, index_of(side, actuator)));
    };
    const int in = which.inputs.front();
    const int out = which.outputs.front();
    if (turns(NetworkSide::motion, index_of(NetworkSide::motion, in)) !=
        turns(NetworkSide::motion, index_of(NetworkSide::motion, out))) {
      taped.ratio_unit = unit_of(NetworkSide::motion, out);
      taped.ratio_per = unit_of(NetworkSide::motion, in);
      taped.torque_ratio_unit = unit_of(NetworkSide::action, out);
      taped.torque_ratio_per = unit_of(NetworkSide::action, in);
    }
    if (which.inputs.size() > 1) {
      return;
    }
    for (std::size_t q = 0; q < task_.quantities.size(); ++q) {
      const SweepQuantityKind kind = task_.quantities[q].kind;
      if (kind == SweepQuantityKind::ratio) {
        const TapeNumber ratio = scaled(
            quotient(taped.input_rates, taped.output_rates), taped.ratio_unit, taped.ratio_per);
        taped.ratios.push_back({.column = q, .cell = add_output(ratio)});
      } else if (kind == SweepQuantityKind::torque_ratio && !taped.input_actions.empty()) {
        const TapeNumber ratio = scaled(quotient(taped.input_actions, taped.output_actions),
                                        taped.torque_ratio_unit,
                                        taped.torque_ratio_per);
        taped.ratios.push_back({.column = q, .cell = add_output(ratio)});
      }
    }
  }

  TapeNumber quotient(const std::vector<std::size_t>& above,
                      const std::vector<std::size_t>& below) {
    return recorder_.divide(outputs_[above.front()], outputs_[below.front()]);
  }

  TapeNumber scaled(TapeNumber number, double unit, double per) {
    return recorder_.divide(recorder_.multiply(number, recorder_.constant(unit)),
                            recorder_.constant(per));
  }

  const SweepTask& task_;
  const Rebinder& rebinder_;
  const Topology& topology_;
  std::span<const SweepSample> samples_;
  std::vector<Geometry> geometries_;
  LaneRecorder recorder_;
  std::vector<std::optional<TapeQuantity>> slots_;  ///< of each parameter
  TapedScrews screws_;
  std::vector<TapeNumber> outputs_;
  std::optional<SweepTapes> tapes_;
};

}  // namespace

std::optional<SweepTapes> record_tapes(const SweepTask& task) {
  // What a case that the file does not write itself knows is not looked into.
  const std::size_t written = task.description.cases.size();
  if (std::ranges::any_of(task.chosen, [&](std::size_t i) { return i >= written; })) {
    return std::nullopt;
  }
  if (!knows_gears(task)) {
    return std::nullopt;
  }
  std::optional<Rebinder> rebinder =
      Rebinder::make(task.description, task.mechanism, varying_parameters(task.plan));
  if (!rebinder) {
    return std::nullopt;
  }
  const auto samples = find_samples(task, *rebinder);
  if (!samples) {
    return std::nullopt;
  }
  for (const NearOrigin near : {NearOrigin::by_fixed_points, NearOrigin::by_all_points}) {
    SweepRecorder by_formulas(task, *rebinder, *samples);
    if (by_formulas.record_geometry(near)) {
      return by_formulas.record_cases();
    }
  }
  SweepRecorder by_states(task, *rebinder, *samples);
  by_states.take_geometry();
  return by_states.record_cases();
}

}  // namespace kinestat
