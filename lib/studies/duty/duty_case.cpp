#include "studies/duty/duty_case.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cases/solve_cases.hpp"
#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "couplings/kinds.hpp"
#include "dynamics/spring_power.hpp"
#include "mechanism/gears/coast_flanks.hpp"
#include "power/stored_power.hpp"
#include "power/transmission_efficiency.hpp"
#include "statics/friction_law.hpp"

namespace kinestat {

namespace {

bool has_one_freedom(FrictionKind kind) {
  return kind == FrictionKind::journal || kind == FrictionKind::thread ||
         kind == FrictionKind::guide || kind == FrictionKind::drag || kind == FrictionKind::fluid;
}

double power_of(const std::vector<int>& actuators, const std::vector<double>& powers) {
  double sum = 0.0;
  for (const int i : actuators) {
    sum += powers[static_cast<std::size_t>(i)];
  }
  return sum;
}

bool drives_from_both_ends(const Case& which, const std::vector<double>& powers) {
  return !which.inputs.empty() && !which.outputs.empty() && power_of(which.inputs, powers) > 0.0 &&
         power_of(which.outputs, powers) > 0.0;
}

std::vector<double> actuator_powers(const Topology& topology,
                                    const std::vector<double>& rates,
                                    std::span<const double> actions) {
  std::vector<double> powers;
  for (const ActuatorTopology& one : topology.actuators) {
    powers.push_back(rates[static_cast<std::size_t>(one.freedom)] *
                     actions[static_cast<std::size_t>(one.action)]);
  }
  return powers;
}

// How the gears of a mesh turn in its carrier, for an angular velocity of 1; zero where they do
// not.
struct MeshTwists {
  Twist head;
  Twist tail;
};

Twist unit_of(const Twist& twist) {
  const double size = twist.angular.norm();
  return size > 0.0 ? (1.0 / size) * twist : Twist{};
}

std::vector<MeshTwists> find_mesh_twists(const Topology& topology,
                                         const KinematicSolution& motion,
                                         std::span<const Mesh> meshes) {
  std::vector<MeshTwists> result;
  for (const Mesh& mesh : meshes) {
    const CouplingTopology& coupling = topology.coupling(mesh.coupling);
    const BodyId carrier = mesh.carrier.value_or(coupling.head);
    const auto of = [&](BodyId gear) {
      return unit_of(motion.bodies[static_cast<std::size_t>(gear.value)] -
                     motion.bodies[static_cast<std::size_t>(carrier.value)]);
    };
    result.push_back(mesh.carrier ? MeshTwists{of(coupling.head), of(coupling.tail)}
                                  : MeshTwists{});
  }
  return result;
}

// Adds torques of teeth and forces of couplings to a state that has actions and speeds.
void add_forces(const Topology& topology,
                const Geometry& geometry,
                std::span<const Mesh> meshes,
                std::span<const MeshTwists> twists,
                DutyState& state) {
  std::vector<std::optional<Wrench>> wrenches(topology.couplings.size(), Wrench{});
  for (std::size_t a = 0; a < state.actions.size(); ++a) {
    std::optional<Wrench>& wrench =
        wrenches[static_cast<std::size_t>(topology.actions[a].coupling.value)];
    wrench = wrench && state.actions[a]
                 ? std::optional(*wrench + *state.actions[a] * geometry.actions[a])
                 : std::nullopt;
  }
  for (const std::optional<Wrench>& wrench : wrenches) {
    state.forces.push_back(wrench ? std::optional(wrench->force) : std::nullopt);
  }
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const auto& teeth = wrenches[static_cast<std::size_t>(meshes[m].coupling.value)];
    const auto torque = [&](const Twist& twist) -> std::optional<double> {
      if (twist.angular.isZero(0.0)) {
        return 0.0;
      }
      return teeth ? std::optional(std::abs(power(*teeth, twist))) : std::nullopt;
    };
    state.teeth[m].head.torque = torque(twists[m].head);
    state.teeth[m].tail.torque = torque(twists[m].tail);
  }
}

std::size_t index_of(std::span<const LossyMesh> meshes, CouplingId coupling) {
  return static_cast<std::size_t>(std::ranges::find(meshes, coupling, &LossyMesh::coupling) -
                                  meshes.begin());
}

}  // namespace

bool has_plain_statics(const Mechanism& mechanism) {
  const Topology& topology = mechanism.topology;
  return mechanism.contacts.empty() && mechanism.springs.empty() && mechanism.curves.empty() &&
         std::ranges::none_of(mechanism.cases, &Case::has_inertia) &&
         std::ranges::none_of(topology.couplings,
                              [](const CouplingTopology& one) {
                                return kind_of(one.type).only_pushes || one.bears_tension();
                              }) &&
         std::ranges::all_of(mechanism.frictions, [&](const CouplingFriction& one) {
           return one.cables.empty() &&
                  has_one_freedom(kind_of(topology.coupling(one.coupling).type).friction);
         });
}

namespace {

// What turns freely has no speed, be it assumed to be at rest or not.
void forget_idle(const Topology& topology,
                 const KinematicSolution& motion,
                 std::span<const Mesh> meshes,
                 DutyState& state) {
  for (int f = 0; f < topology.freedom_count(); ++f) {
    if (!motion.knows_rate(f)) {
      state.rates[static_cast<std::size_t>(f)] = kUnknownSpeed;
    }
  }
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const CouplingTopology& coupling = topology.coupling(meshes[m].coupling);
    const bool knows_carrier = !meshes[m].carrier || motion.knows_body(*meshes[m].carrier);
    for (const bool is_head : {false, true}) {
      if (!knows_carrier || !motion.knows_body(is_head ? coupling.head : coupling.tail)) {
        (is_head ? state.teeth[m].head : state.teeth[m].tail).speed = kUnknownSpeed;
      }
    }
  }
}

// Damping is a loss; what stiffness and masses take they give back some time.
void add_loads(const Mechanism& mechanism, const CaseAnalysis& one, DutyState& state) {
  const std::vector<double>& powers = one.power->loads;
  const std::vector<Load>& loads = one.which.loads;
  const std::vector<SpringPower> springs = spring_powers(mechanism, one.springs, loads, powers);
  double stored = kPowerBalance * one.power->largest;
  const auto add = [&](double power, const Load& load) {
    state.loads.push_back(power);
    std::string reason = stored_power_reason(load);
    if (std::abs(power) > stored && !reason.empty()) {
      stored = std::abs(power);
      state.no_efficiency = std::move(reason);
    }
  };
  for (std::size_t i = 0; i < loads.size(); ++i) {
    if (springs.empty() || i < springs.front().first ||
        i >= springs.back().first + springs.back().load_count) {
      add(powers[i], loads[i]);
    }
  }
  for (const SpringPower& spring : springs) {
    add(spring.given, loads[spring.first]);
    state.dampers.push_back(-spring.lost);
  }
}

}  // namespace

std::optional<DutyState> state_of(const Mechanism& mechanism,
                                  const CaseAnalysis& one,
                                  std::span<const Mesh> meshes) {
  const bool has_losses = !mechanism.lossy_meshes.empty();
  if (!one.power || (has_losses && !(one.efficiency && one.efficiency->state))) {
    return std::nullopt;
  }
  const auto& actions = has_losses ? one.efficiency->state->actions : one.action->magnitudes;
  DutyState result{.rates = one.motion->rates, .actions = actions};
  result.actuators = has_losses ? one.efficiency->state->actuators : one.power->actuators;
  add_loads(mechanism, one, result);
  result.friction.assign(mechanism.frictions.size(), 0.0);
  const std::vector<double>& lost =
      has_losses ? one.efficiency->state->friction : one.power->friction;
  for (std::size_t i = 0; i < lost.size(); ++i) {
    const auto at = std::ranges::find(
        mechanism.frictions, one.action->friction[i].coupling, &CouplingFriction::coupling);
    result.friction[static_cast<std::size_t>(at - mechanism.frictions.begin())] = lost[i];
  }
  if (has_losses) {
    for (const MeshLossPower& mesh : one.efficiency->state->meshes) {
      result.meshes.push_back(mesh.power);
    }
  }
  for (const Mesh& mesh : meshes) {
    const CouplingTopology& coupling = mechanism.topology.coupling(mesh.coupling);
    const BodyId carrier = mesh.carrier.value_or(coupling.head);
    const auto speed = [&](BodyId gear) {
      return (one.motion->bodies[static_cast<std::size_t>(gear.value)] -
              one.motion->bodies[static_cast<std::size_t>(carrier.value)])
          .angular.norm();
    };
    result.teeth.push_back(mesh.carrier ? MeshState{.head = {.speed = speed(coupling.head)},
                                                    .tail = {.speed = speed(coupling.tail)}}
                                        : MeshState{});
  }
  Geometry geometry = mechanism.geometry;
  load_coast_flanks(one.coast_flanks, geometry);
  add_forces(mechanism.topology,
             geometry,
             meshes,
             find_mesh_twists(mechanism.topology, *one.motion, meshes),
             result);
  result.drives_from_both_ends = drives_from_both_ends(one.which, result.actuators);
  forget_idle(mechanism.topology, *one.motion, meshes, result);
  return result;
}

// A gear of a mesh in its carrier, about an axis in the sense in which it turned.
struct GearSense {
  BodyId gear;
  BodyId carrier;
  Vec3 axis = Vec3::Zero();  ///< zero where it did not turn
};

// A friction in the sense in which its coupling moved.
struct DutyFrictionSense {
  std::size_t friction = 0;  ///< index into mechanism.frictions
  int freedom = 0;
  double sense = 0.0;        ///< 0 where it did not move; of a torque converter that of its couple
  Vec3 axis = Vec3::Zero();  ///< of a torque converter
};

struct DutyCase::Prepared {
  // Gives a system what acts and moves there; false where a friction has no value.
  bool set(LossySystem& to,
           std::span<const std::optional<FrictionPoint>> points,
           std::span<const double> actions) const {
    to.set_primaries(actions);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!points[i]) {
        return false;
      }
      to.set_friction(i, points[i]->speed, points[i]->constant);
    }
    return true;
  }

  std::vector<DutyFrictionSense> frictions;            ///< in the order of mechanism.frictions
  std::vector<std::pair<GearSense, GearSense>> laws;   ///< head and tail of each mesh that loses
  std::vector<std::pair<GearSense, GearSense>> turns;  ///< of all meshes, in their order
  std::vector<MeshTwists> twists;                      ///< likewise
  std::vector<std::size_t> lossy;  ///< index into mechanism.lossy_meshes of each of `laws`
  std::vector<Primary> primaries;
  std::vector<BodyWrench> loads;
  std::optional<LossySystem> without_mesh_losses;
  std::optional<LossySystem> system;
};

DutyCase::~DutyCase() = default;

DutyCase::DutyCase(const Mechanism& drawn,
                   Case which,
                   const CaseMotions& motions,
                   std::span<const Mesh> meshes)
    : mechanism_(drawn), which_(std::move(which)), motions_(motions), meshes_(meshes) {
  analysis_ = std::move(solve_some_cases(drawn, std::span(&which_, 1)).front());
  const bool is_determined = analysis_.action && analysis_.action->check.undetermined.empty();
  if (!is_determined || !state_of(drawn, analysis_, meshes)) {
    return;
  }
  load_coast_flanks(analysis_.coast_flanks, mechanism_.geometry);
  const KinematicSolution& motion = *analysis_.motion;
  auto prepared = std::make_unique<Prepared>();
  std::vector<FrictionLaw> frictions;
  const auto laws = find_friction_laws(mechanism_, which_, motion);
  for (std::size_t i = 0; i < laws.size(); ++i) {
    const CouplingId coupling = mechanism_.frictions[i].coupling;
    const int freedom = mechanism_.topology.coupling(coupling).first_freedom;
    const double rate = motion.rates[static_cast<std::size_t>(freedom)];
    const bool moves = laws[i]->speed > 0.0;
    const Vec3 axis = mechanism_.geometry.motions[static_cast<std::size_t>(freedom)].angular;
    const bool is_fluid = mechanism_.frictions[i].converter != nullptr;
    const double couple = laws[i]->constant * laws[i]->unit.moment.dot(axis);
    const double way = is_fluid ? couple : moves ? rate : 0.0;
    prepared->frictions.push_back({.friction = i,
                                   .freedom = freedom,
                                   .sense = way == 0.0 ? 0.0 : std::copysign(1.0, way),
                                   .axis = is_fluid ? axis : Vec3::Zero()});
    frictions.push_back(*laws[i]);
  }
  const auto sense_of = [&](BodyId gear, BodyId carrier) {
    const Vec3 turning = (motion.bodies[static_cast<std::size_t>(gear.value)] -
                          motion.bodies[static_cast<std::size_t>(carrier.value)])
                             .angular;
    const double size = turning.norm();
    return GearSense{
        .gear = gear, .carrier = carrier, .axis = size > 0.0 ? Vec3(turning / size) : turning};
  };
  const MeshLossLaws losses = find_mesh_loss_laws(mechanism_, motion);
  for (const MeshLossLaw& law : losses.laws) {
    const BodyPair head = *law.head_driven.between;
    const BodyPair tail = *law.tail_driven.between;
    prepared->laws.emplace_back(sense_of(head.head, head.tail), sense_of(tail.head, tail.tail));
    prepared->lossy.push_back(index_of(mechanism_.lossy_meshes, law.head_driven.coupling));
  }
  for (const Mesh& mesh : meshes_) {
    const CouplingTopology& coupling = mechanism_.topology.coupling(mesh.coupling);
    const BodyId carrier = mesh.carrier.value_or(coupling.head);
    prepared->turns.emplace_back(sense_of(coupling.head, carrier),
                                 sense_of(coupling.tail, carrier));
  }
  prepared->twists = find_mesh_twists(mechanism_.topology, motion, meshes_);
  prepared->primaries = which_.actions;
  prepared->loads = wrenches_of(which_.loads);
  const LossyStatics given{.primaries = prepared->primaries,
                           .loads = prepared->loads,
                           .frictions = frictions,
                           .meshes = losses.laws};
  const CoordinateBasis basis = lossy_action_basis(mechanism_, given);
  LossyStatics without = given;
  without.meshes = {};
  prepared->without_mesh_losses.emplace(mechanism_, basis, without, *analysis_.action);
  prepared->system.emplace(mechanism_, basis, given, *analysis_.action);
  prepared_ = std::move(prepared);
}

bool DutyCase::moves_alike(std::span<const double> known) const {
  KINESTAT_EXPECTS(is_prepared());
  const bool frictions =
      std::ranges::all_of(prepared_->frictions, [&](const DutyFrictionSense& one) {
        if (const ConverterLaw* law = mechanism_.frictions[one.friction].converter.get()) {
          const std::optional<double> couple = couple_of(*law, one, known);
          return !couple || (one.sense == 0.0 ? *couple == 0.0 : *couple * one.sense > 0.0);
        }
        const double rate = motions_.rate(one.freedom, known);
        return one.sense == 0.0 ? rate == 0.0 : rate * one.sense > 0.0;
      });
  const auto turns_alike = [&](const GearSense& one) {
    const Vec3 turning = motions_.turning(one.gear, one.carrier, known);
    return one.axis.isZero(0.0) ? turning.isZero(0.0) : turning.dot(one.axis) > 0.0;
  };
  return frictions && std::ranges::all_of(prepared_->turns, [&](const auto& pair) {
           return turns_alike(pair.first) && turns_alike(pair.second);
         });
}

// Of a torque converter, on its turbine.
std::optional<double> DutyCase::couple_of(const ConverterLaw& law,
                                          const DutyFrictionSense& friction,
                                          std::span<const double> known) const {
  return law.couple(motions_.turning(law.pump, law.stator, known).dot(friction.axis),
                    motions_.turning(law.turbine, law.stator, known).dot(friction.axis));
}

std::vector<std::optional<FrictionPoint>> DutyCase::friction_points(
    std::span<const double> known) const {
  std::vector<std::optional<FrictionPoint>> points;
  for (const DutyFrictionSense& sense : prepared_->frictions) {
    const CouplingFriction& one = mechanism_.frictions[sense.friction];
    const double rate = motions_.rate(sense.freedom, known);
    if (one.converter) {
      const std::optional<double> couple = couple_of(*one.converter, sense, known);
      points.push_back(couple ? std::optional(FrictionPoint{.speed = -sense.sense * rate,
                                                            .constant = std::abs(*couple)})
                              : std::nullopt);
      continue;
    }
    const double speed = sense.sense * rate;
    const std::optional<double> tau = speed > 0.0 ? tau_at(one, speed) : 0.0;
    points.push_back(
        tau ? std::optional(FrictionPoint{.speed = speed,
                                          .constant = one.planets * (*tau + one.viscous * speed)})
            : std::nullopt);
  }
  return points;
}

bool DutyCase::presses_alike(std::span<const double> motions, std::span<const double> actions) {
  if (mechanism_.geometry.other_flanks.empty()) {
    return true;
  }
  LossySystem& system = *prepared_->without_mesh_losses;
  if (!prepared_->set(system, friction_points(motions), actions)) {
    return true;
  }
  const auto found = system.solve([](const VecX&) { return true; });
  if (!found) {
    return false;
  }
  const double zero = kCancellation * found->actions.cwiseAbs().maxCoeff();
  const auto force_of = [&](int action) {
    const double force = found->actions[action];
    return std::abs(force) > zero ? force : 0.0;
  };
  return coast_flanks_under(mechanism_.geometry, analysis_.coast_flanks, force_of) ==
         analysis_.coast_flanks;
}

std::optional<DutyState> DutyCase::state_at(std::span<const double> motions,
                                            std::span<const double> actions) {
  KINESTAT_EXPECTS(is_prepared());
  LossySystem& system = *prepared_->system;
  const std::vector<std::optional<FrictionPoint>> points = friction_points(motions);
  if (!prepared_->set(system, points, actions)) {
    return std::nullopt;
  }
  const auto turning = [&](const GearSense& one) {
    return one.axis.isZero(0.0) ? 0.0
                                : motions_.turning(one.gear, one.carrier, motions).dot(one.axis);
  };

  struct Rolling {
    double head = 0.0;
    double tail = 0.0;
  };

  std::vector<Rolling> rolling;
  for (std::size_t m = 0; m < prepared_->laws.size(); ++m) {
    const auto& [head, tail] = prepared_->laws[m];
    rolling.push_back({.head = turning(head), .tail = turning(tail)});
    system.set_mesh_speeds(m, rolling.back().head, rolling.back().tail);
  }
  DutyState result;
  const Topology& topology = mechanism_.topology;
  for (int f = 0; f < topology.freedom_count(); ++f) {
    result.rates.push_back(motions_.rate(f, motions));
  }
  const auto powers = [&](const VecX& magnitudes) {
    return actuator_powers(
        topology,
        result.rates,
        std::span(magnitudes.data(), static_cast<std::size_t>(magnitudes.size())));
  };
  // The outputs take power, if the inputs give any.
  const std::optional<LossyMagnitudes> found = system.solve(
      [&](const VecX& magnitudes) { return !drives_from_both_ends(which_, powers(magnitudes)); });
  if (!found || found->search == LossSearch::undecided) {
    return std::nullopt;
  }
  result.actions.assign(found->actions.begin(), found->actions.end());
  result.actuators = powers(found->actions);
  for (const Load& load : which_.loads) {
    result.loads.push_back(power(load.acts.wrench, motions_.body(load.acts.body, motions)));
  }
  result.friction.assign(mechanism_.frictions.size(), 0.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    result.friction[prepared_->frictions[i].friction] = -found->frictions[i] * points[i]->speed;
  }
  result.meshes.assign(mechanism_.lossy_meshes.size(), 0.0);
  for (std::size_t m = 0; m < rolling.size(); ++m) {
    const double speed = found->head_is_driven[m] ? rolling[m].head : rolling[m].tail;
    result.meshes[prepared_->lossy[m]] = -found->losses[m] * speed;
  }
  for (const auto& [head, tail] : prepared_->turns) {
    result.teeth.push_back({.head = {.speed = turning(head)}, .tail = {.speed = turning(tail)}});
  }
  add_forces(topology, mechanism_.geometry, meshes_, prepared_->twists, result);
  result.drives_from_both_ends = drives_from_both_ends(which_, result.actuators);
  return result;
}

}  // namespace kinestat
