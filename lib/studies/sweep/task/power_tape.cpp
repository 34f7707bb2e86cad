#include "studies/sweep/task/power_tape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "power/net_shafts.hpp"
#include "statics/mesh_loss_law.hpp"
#include "studies/sweep/task/internal/absolute_tape.hpp"
#include "studies/sweep/task/internal/tape_arithmetic.hpp"
#include "studies/sweep/task/sweep_task.hpp"

namespace kinestat {

namespace {

bool needs_absolute(const SweepTask& task) {
  return task.mechanism.loss_model == LossModel::absolute &&
         asks(task.columns, SweepColumnKind::efficiency);
}

void sort_out(std::vector<int>& indices) {
  std::ranges::sort(indices);
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
}

std::vector<int> actions_of(const CouplingTopology& coupling) {
  std::vector<int> actions;
  for (int a = 0; a < coupling.action_count; ++a) {
    actions.push_back(coupling.first_action + a);
  }
  return actions;
}

// A mesh that loses power, in the sense that it has in the recorded state.
struct LossyTeeth {
  CouplingId coupling;
  BodyId carrier;
  BodyId driven;
  double sign = 1.0;  ///< of the power into the head of the mesh where that drives this gear
  TapeNumber share;
  std::vector<TapedCouple::Share> powers;  ///< into the head, seen from the carrier, per action
};

class PowerRecorder {
 public:
  PowerRecorder(const SweepTask& task, const TapedCase& taped, SweepNotes& notes)
      : task_(task),
        mechanism_(task.mechanism),
        topology_(task.mechanism.topology),
        taped_(taped),
        solved_(taped.solved),
        notes_(notes),
        recorder_(notes.recorder) {}

  std::optional<LossyTape> run() {
    if (!solved_.power || !solved_.action->friction.empty()) {
      return std::nullopt;
    }
    LossyTape result;
    // Whatever is asked of the power, the status says whether losses lock the case.
    if (!mechanism_.lossy_meshes.empty() && !add_losses(result)) {
      return std::nullopt;
    }
    if (asks(task_.columns, SweepColumnKind::recirculation)) {
      add_recirculation(result.power);
    }
    return result;
  }

 private:
  bool add_losses(LossyTape& result) {
    const Case& which = solved_.which;
    LossTape losses;
    const bool names_both = which.names_both_ends();
    const bool is_known = solved_.efficiency && solved_.efficiency->state &&
                          (!names_both || solved_.efficiency->carrier.value);
    if (!is_known || !find_teeth() || (names_both && !add_absolute(losses))) {
      return false;
    }
    std::vector<TapedCouple> couples;
    for (const LossyTeeth& teeth : teeth_) {
      demand_sense(teeth, taped_.action);
      couples.push_back(couple_of(teeth));
    }
    TapedSide action{.wanted = actions_with_losses(), .network = {}};
    TapedSystem equilibrium = taped_.equilibrium;
    equilibrium.wanted = action.wanted;
    equilibrium.couples = couples;
    auto network = record_network(equilibrium, recorder_);
    if (!network) {
      return false;
    }
    action.network = *std::move(network);
    for (const LossyTeeth& teeth : teeth_) {
      demand_sense(teeth, action);
    }
    add_powers(couples, action, losses);
    result.power.losses = std::move(losses);
    result.action = std::move(action);
    return true;
  }

  // True where another model counts.
  bool add_absolute(LossTape& losses) {
    if (!needs_absolute(task_)) {
      return true;
    }
    if (!solved_.efficiency->absolute.value) {
      return false;
    }
    std::vector<TapedPower> couplings;
    for (int e = 0; e < topology_.coupling_count(); ++e) {
      const CouplingTopology& coupling = topology_.coupling(CouplingId{e});
      couplings.push_back({.into_head = power_on(CouplingId{e}, coupling.head),
                           .out_of_tail = power_on(CouplingId{e}, coupling.tail)});
    }
    const std::vector<TapeNumber> actuators = actuator_powers();
    const auto efficiency = record_absolute_efficiency({.mechanism = mechanism_,
                                                        .solved = solved_,
                                                        .couplings = couplings,
                                                        .actuators = actuators,
                                                        .shares = taped_.shares},
                                                       recorder_);
    if (!efficiency) {
      return false;
    }
    losses.absolute = notes_.add_output(*efficiency);
    for (const TapeNumber one : actuators) {
      losses.lossless.push_back(notes_.add_output(one));
    }
    return true;
  }

  // Without losses.
  std::vector<TapeNumber> actuator_powers() {
    std::vector<TapeNumber> powers;
    for (const ActuatorTopology& actuator : topology_.actuators) {
      powers.push_back(recorder_.multiply(taped_.action.number(actuator.action),
                                          taped_.motion.number(actuator.freedom)));
    }
    return powers;
  }

  // Of each mesh that loses any. False where the recorded state has no senses that a tape can keep.
  bool find_teeth() {
    const MeshLossLaws losses = find_mesh_loss_laws(mechanism_, *solved_.motion);
    for (const CouplingId mesh : losses.not_rolling) {
      // As long as it does not roll it loses nothing; its carrier is that of any law of it.
      if (!demand_no_rolling(mesh)) {
        return false;
      }
    }
    return losses.without_carrier.empty() && !may_begin_to_lose() &&
           std::ranges::all_of(losses.laws,
                               [this](const MeshLossLaw& law) { return add_teeth(law); });
  }

  // A mesh without loss in the recorded state alone.
  bool may_begin_to_lose() const {
    return std::ranges::any_of(taped_.shares, [this](TapeNumber share) {
      return recorder_.value(share) == 0.0 && !recorder_.is_constant(share);
    });
  }

  bool add_teeth(const MeshLossLaw& law) {
    const CouplingId mesh = law.head_driven.coupling;
    const BodyId carrier = law.head_driven.between->tail;
    const TapedScrew on_carrier = relative(topology_.coupling(mesh).head, carrier);
    LossyTeeth teeth{.coupling = mesh,
                     .carrier = carrier,
                     .driven = law.head_driven.between->head,
                     .share = share_of(mesh),
                     .powers = {}};
    for (const int action : actions_of(topology_.coupling(mesh))) {
      teeth.powers.push_back({.action = action, .per_action = power_per(action, on_carrier)});
    }
    const double into_head = recorder_.value(power_of(teeth, taped_.action));
    if (into_head < 0.0) {
      teeth.sign = -1.0;
      teeth.driven = law.tail_driven.between->head;
    }
    const auto& found =
        *std::ranges::find(solved_.efficiency->state->meshes, mesh, &MeshLossPower::mesh);
    const bool is_as_without_losses = !found.driven || *found.driven == teeth.driven;
    if (!is_as_without_losses || !turns_on_one_axis(teeth)) {
      return false;
    }
    teeth_.push_back(std::move(teeth));
    return true;
  }

  TapeNumber share_of(CouplingId mesh) const {
    const auto at = std::ranges::find(mechanism_.lossy_meshes, mesh, &LossyMesh::coupling);
    return taped_.shares[static_cast<std::size_t>(at - mechanism_.lossy_meshes.begin())];
  }

  // The coordinate of the axis about which a gear turns on its carrier.
  std::optional<int> axis_of(BodyId gear, BodyId carrier) {
    std::optional<int> axis;
    const TapedScrew twist = relative(gear, carrier);
    for (int i = 0; i < 3; ++i) {
      if (!recorder_.is_zero(twist[static_cast<std::size_t>(i)])) {
        if (axis) {
          return std::nullopt;
        }
        axis = i;
      }
    }
    return axis;
  }

  TapeNumber turning(BodyId gear, BodyId carrier, int axis) {
    return relative(gear, carrier)[static_cast<std::size_t>(axis)];
  }

  // Clearly, in every lane.
  bool turns_on_one_axis(const LossyTeeth& teeth) {
    const CouplingTopology& coupling = topology_.coupling(teeth.coupling);
    return std::ranges::all_of(std::array{coupling.head, coupling.tail}, [&](BodyId gear) {
      const std::optional<int> axis = axis_of(gear, teeth.carrier);
      if (!axis) {
        return false;
      }
      const auto i = static_cast<std::size_t>(*axis);
      const TapeNumber speeds = recorder_.add(size_on_tape(body(gear)[i], recorder_),
                                              size_on_tape(body(teeth.carrier)[i], recorder_));
      recorder_.demand_at_least(turning(gear, teeth.carrier, *axis),
                                recorder_.multiply(speeds, recorder_.constant(kSameValue)));
      return true;
    });
  }

  bool demand_no_rolling(CouplingId mesh) {
    const auto meshes = find_meshes(topology_, mechanism_.geometry);
    const auto at = std::ranges::find(meshes, mesh, &Mesh::coupling);
    KINESTAT_EXPECTS(at != meshes.end() && at->carrier);
    for (const BodyId gear : {topology_.coupling(mesh).head, topology_.coupling(mesh).tail}) {
      const TapedScrew twist = relative(gear, *at->carrier);
      const bool is_at_rest = std::ranges::all_of(
          std::span(twist).first(3), [&](TapeNumber one) { return recorder_.value(one) == 0.0; });
      if (is_at_rest) {
        for (const TapeNumber one : std::span(twist).first(3)) {
          recorder_.demand_at_most(one, recorder_.constant(0.0));
        }
        return true;
      }
    }
    return false;
  }

  // The couple that holds the driven gear back.
  TapedCouple couple_of(const LossyTeeth& teeth) {
    const int axis = *axis_of(teeth.driven, teeth.carrier);
    TapedCouple couple{.tail = teeth.carrier,
                       .head = teeth.driven,
                       .coordinate = axis,
                       .speed = turning(teeth.driven, teeth.carrier, axis),
                       .shares = {}};
    const TapeNumber lost = recorder_.multiply(teeth.share, recorder_.constant(teeth.sign));
    for (const TapedCouple::Share& one : teeth.powers) {
      couple.shares.push_back(
          {.action = one.action, .per_action = recorder_.multiply(one.per_action, lost)});
    }
    return couple;
  }

  // That the teeth do not drive the other gear.
  void demand_sense(const LossyTeeth& teeth, const TapedSide& action) {
    const TapeNumber forwards =
        recorder_.multiply(power_of(teeth, action), recorder_.constant(teeth.sign));
    const TapeNumber zero = recorder_.constant(0.0);
    recorder_.demand_at_most(recorder_.smaller(forwards, zero), zero);
  }

  TapeNumber power_of(const LossyTeeth& teeth, const TapedSide& action) {
    TapeNumber sum = recorder_.constant(0.0);
    for (const TapedCouple::Share& one : teeth.powers) {
      sum = recorder_.add(sum, recorder_.multiply(action.number(one.action), one.per_action));
    }
    return sum;
  }

  std::vector<int> actions_with_losses() const {
    std::vector<int> wanted;
    for (const ActuatorTopology& actuator : topology_.actuators) {
      wanted.push_back(actuator.action);
    }
    for (const LossyTeeth& teeth : teeth_) {
      for (const TapedCouple::Share& one : teeth.powers) {
        wanted.push_back(one.action);
      }
    }
    for (const SweepColumn& column : task_.columns) {
      if (column.kind == SweepColumnKind::lossy_action) {
        wanted.push_back(column.index);
      }
    }
    sort_out(wanted);
    return wanted;
  }

  void add_powers(const std::vector<TapedCouple>& couples,
                  const TapedSide& action,
                  LossTape& losses) {
    TapeNumber sum = recorder_.constant(0.0);
    for (std::size_t i = 0; i < couples.size(); ++i) {
      const TapeNumber loss = recorder_.multiply(action.network.couples[i], couples[i].speed);
      sum = recorder_.add(sum, loss);
    }
    for (const ActuatorTopology& actuator : topology_.actuators) {
      const TapeNumber one = recorder_.multiply(action.number(actuator.action),
                                                taped_.motion.number(actuator.freedom));
      sum = recorder_.add(sum, one);
      losses.actuators.push_back(notes_.add_output(one));
    }
    losses.imbalance = notes_.add_output(sum);
  }

  // As PowerGraph::net sums what goes from shaft to shaft: but for its sign it does not matter
  // which of two gives more.
  void add_recirculation(PowerTape& power) {
    const std::vector<Mesh> meshes = find_meshes(topology_, mechanism_.geometry);
    const NetShafts shafts(topology_, meshes);
    std::vector<NetPart> parts;
    for (int e = 0; e < topology_.coupling_count(); ++e) {
      const NetPart part = part_of(CouplingId{e}, shafts);
      if (part.from != part.to) {
        parts.push_back(part);
      }
    }
    TapeNumber largest = recorder_.constant(0.0);
    std::vector<bool> is_done(parts.size(), false);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (is_done[i]) {
        continue;
      }
      TapeNumber sum = parts[i].power;
      for (std::size_t j = i + 1; j < parts.size() && parts[i].is_summed; ++j) {
        const double sense = parts[i].sense_of(parts[j]);
        if (sense != 0.0) {
          is_done[j] = true;
          sum = sense > 0.0 ? recorder_.add(sum, parts[j].power)
                            : recorder_.subtract(sum, parts[j].power);
        }
      }
      largest = recorder_.larger(largest, size_on_tape(sum, recorder_));
    }
    power.largest = notes_.add_output(largest);
    power.input = notes_.add_output(input_power());
  }

  // Of the inputs, or all that actuators give where the case names none. Where those of several
  // cancel, the whole analysis decides whether they are zero.
  TapeNumber input_power() {
    const std::vector<int>& inputs = solved_.which.inputs;
    const TapeNumber zero = recorder_.constant(0.0);
    TapeNumber input = zero;
    TapeNumber terms = zero;
    const std::vector<TapeNumber> powers = actuator_powers();
    for (std::size_t i = 0; i < powers.size(); ++i) {
      if (inputs.empty()) {
        input = recorder_.add(input, recorder_.larger(powers[i], zero));
      } else if (std::ranges::find(inputs, static_cast<int>(i)) != inputs.end()) {
        input = recorder_.add(input, powers[i]);
        terms = recorder_.add(terms, size_on_tape(powers[i], recorder_));
      }
    }
    recorder_.demand_at_least(input, recorder_.multiply(terms, recorder_.constant(kSameValue)));
    return input;
  }

  // What goes by one coupling from one shaft to another.
  struct NetPart {
    BodyId from;
    BodyId to;
    bool is_summed = false;
    bool bears_planet = false;
    TapeNumber power;

    double sense_of(const NetPart& other) const {
      if (!other.is_summed || other.bears_planet != bears_planet) {
        return 0.0;
      }
      return from == other.from && to == other.to   ? 1.0
             : from == other.to && to == other.from ? -1.0
                                                    : 0.0;
    }
  };

  NetPart part_of(CouplingId id, const NetShafts& shafts) {
    const CouplingTopology& coupling = topology_.coupling(id);
    NetPart part{.from = shafts.shaft_of(coupling.tail),
                 .to = shafts.shaft_of(coupling.head),
                 .is_summed = shafts.is_summed(id),
                 .bears_planet = shafts.bears_planet(id),
                 .power = recorder_.constant(0.0)};
    if (part.bears_planet) {
      const bool is_head = shafts.planet_on(id) == coupling.head;
      (is_head ? part.from : part.to) = is_head ? coupling.tail : coupling.head;
      part.power = power_on(id, is_head ? coupling.tail : coupling.head);
    } else if (part.from != part.to) {
      part.power = transmitted(power_on(id, coupling.head), power_on(id, coupling.tail));
    }
    return part;
  }

  // The lesser of what leaves the tail and what reaches the head; nothing where they differ in
  // sign.
  TapeNumber transmitted(TapeNumber into_head, TapeNumber out_of_tail) {
    const TapeNumber zero = recorder_.constant(0.0);
    return recorder_.add(recorder_.larger(recorder_.smaller(into_head, out_of_tail), zero),
                         recorder_.smaller(recorder_.larger(into_head, out_of_tail), zero));
  }

  // The power of a coupling's wrench on the motion of a body.
  TapeNumber power_on(CouplingId id, BodyId moved) {
    TapeNumber sum = recorder_.constant(0.0);
    for (const int action : actions_of(topology_.coupling(id))) {
      sum = recorder_.add(
          sum, recorder_.multiply(taped_.action.number(action), power_per(action, body(moved))));
    }
    return sum;
  }

  TapeNumber power_per(int action, const TapedScrew& twist) {
    const TapedScrew& screw = taped_.equilibrium.screws[static_cast<std::size_t>(action)];
    TapeNumber sum = recorder_.constant(0.0);
    for (std::size_t i = 0; i < screw.size(); ++i) {
      if (!recorder_.is_zero(screw[i]) && !recorder_.is_zero(twist[i])) {
        sum = recorder_.add(sum, recorder_.multiply(screw[i], twist[i]));
      }
    }
    return sum;
  }

  const TapedScrew& body(BodyId id) const {
    return taped_.motion.network.bodies[static_cast<std::size_t>(id.value)];
  }

  TapedScrew relative(BodyId moved, BodyId carrier) {
    TapedScrew result;
    for (std::size_t i = 0; i < result.size(); ++i) {
      result[i] = settled_difference(body(moved)[i], body(carrier)[i], recorder_);
    }
    return result;
  }

  const SweepTask& task_;
  const Mechanism& mechanism_;
  const Topology& topology_;
  const TapedCase& taped_;
  const CaseAnalysis& solved_;
  SweepNotes& notes_;
  LaneRecorder& recorder_;
  std::vector<LossyTeeth> teeth_;
};

}  // namespace

TapeNumber TapedSide::number(int index) const {
  const auto at = std::ranges::lower_bound(wanted, index);
  KINESTAT_EXPECTS(at != wanted.end() && *at == index);
  return network.wanted[static_cast<std::size_t>(at - wanted.begin())];
}

std::vector<int> actions_with_power(const SweepTask& task) {
  const Topology& topology = task.mechanism.topology;
  std::vector<int> wanted;
  for (const ActuatorTopology& actuator : topology.actuators) {
    wanted.push_back(actuator.action);
  }
  for (int e = 0; e < topology.coupling_count(); ++e) {
    const bool is_lossy =
        std::ranges::find(task.mechanism.lossy_meshes, CouplingId{e}, &LossyMesh::coupling) !=
        task.mechanism.lossy_meshes.end();
    if (is_lossy || needs_absolute(task) || asks(task.columns, SweepColumnKind::recirculation)) {
      std::ranges::copy(actions_of(topology.coupling(CouplingId{e})), std::back_inserter(wanted));
    }
  }
  sort_out(wanted);
  return wanted;
}

std::optional<LossyTape> note_power(const SweepTask& task,
                                    const TapedCase& taped,
                                    SweepNotes& notes) {
  return PowerRecorder(task, taped, notes).run();
}

}  // namespace kinestat
