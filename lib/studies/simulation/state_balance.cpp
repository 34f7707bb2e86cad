#include "studies/simulation/state_balance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/index.hpp"
#include "core/motion_tolerance.hpp"
#include "core/tolerance.hpp"
#include "math/numbers/zero_within_bound.hpp"
#include "network/bases.hpp"
#include "statics/action.hpp"
#include "statics/equilibrium.hpp"
#include "statics/indeterminacy.hpp"
#include "studies/motion/moved_mechanism.hpp"

namespace kinestat {

namespace {

// The power that rolls into the gear, over its speed, presses where it is positive. `hinge` is the
// first on its axis.
FrictionLaw law_of_teeth(const Rubbing& one, const Twist& hinge, double sense, double speed) {
  const DrivenGear& gear = *one.gear;
  const Twist turns = (sense * gear.sense) * hinge;
  FrictionLaw law;
  law.coupling = one.coupling;
  law.between = gear.between;
  law.unit = unit_couple<double>(-turns.angular);
  law.speed = speed;
  PressingPart part;
  part.part.row(0) << turns.angular.transpose(), turns.linear.transpose();
  part.part *= gear.is_head ? 1.0 : -1.0;
  const std::optional<double> share = share_at(*gear.mesh, gear.radius * speed, 0.0);
  law.has_value = share.has_value();
  part.weight = share.value_or(0.0);
  part.is_signed = true;
  law.parts = {part};
  return law;
}

// Components that closure may be off by are zero: along a free coordinate nothing else acts on a
// body, and an equation of rounding alone would hold as any other.
void drop_rounding(Wrench& unit) {
  Vec3& direction = unit.force.isZero(0.0) ? unit.moment : unit.force;
  const double size = direction.norm();
  for (double& component : direction) {
    component = zero_within_bound(component, kMotionClosure * size);
  }
}

// An equation of a body in which all actions on it are next to nothing, as along a guide that is
// tilted by so little, says nothing of them that rounding does not: others determine them.
void drop_idle_equations(const Topology& topology, std::vector<Wrench>& units) {
  std::vector<Vec3> largest(topology.bodies.size(), Vec3::Zero());
  const auto for_ends = [&](const auto& act) {
    for (const CouplingTopology& coupling : topology.couplings) {
      for (int a = coupling.first_action; a < coupling.first_action + coupling.action_count; ++a) {
        act(at(coupling.tail.value), units[at(a)].force);
        act(at(coupling.head.value), units[at(a)].force);
      }
    }
  };
  for_ends([&](std::size_t body, const Vec3& force) {
    largest[body] = largest[body].cwiseMax(force.cwiseAbs());
  });
  for_ends([&](std::size_t body, Vec3& force) {
    for (Eigen::Index axis = 0; body != 0 && axis < force.size(); ++axis) {
      force[axis] = largest[body][axis] <= kRankZero ? 0.0 : force[axis];
    }
  });
}

}  // namespace

StateBalance::StateBalance(const Mechanism& mechanism,
                           const MotionNetwork& network,
                           std::span<const DrawnCoupling> drawn)
    : mechanism_(mechanism),
      network_(network),
      drawn_(drawn),
      moved_(mechanism),
      reactions_(coupling_reactions(mechanism)) {
  for (Rubbing one : find_rubbing(mechanism)) {
    one.friction.viscous = 0.0;
    sliding_.push_back(one);
    one.friction.mu = one.friction.mu_static.value_or(one.friction.mu);
    resting_.push_back(std::move(one));
  }
  for (const int action : mechanism.topology.driving_actions()) {
    Primary one;
    one.index = action;
    idle_.push_back(one);
  }
}

void StateBalance::place(const Configuration& configuration,
                         std::span<const BodyPose> poses,
                         double off) {
  move_mechanism(network_, drawn_, configuration, poses, mechanism_, moved_);
  moved_.closure_error = std::max(kMotionClosure, off);
  for (Wrench& unit : moved_.geometry.actions) {
    drop_rounding(unit);
  }
  for (const Primary& one : idle_) {
    moved_.geometry.actions[at(one.index)] = {};
  }
  drop_idle_equations(moved_.topology, moved_.geometry.actions);
  load_coast_flanks(coast_, moved_.geometry);
}

void StateBalance::add_pair(int freedom, double magnitude, std::vector<BodyWrench>& loads) const {
  const FreedomLabel& label = mechanism_.topology.freedoms[at(freedom)];
  const CouplingTopology& coupling = mechanism_.topology.coupling(label.coupling);
  const Twist& unit = moved_.geometry.motions[at(freedom)];
  const Vec3& point = moved_.geometry.points[at(label.coupling.value)];
  const Wrench wrench = magnitude * (label.is_rotation ? unit_couple<double>(unit.angular)
                                                       : unit_force<double>(unit.linear, point));
  loads.push_back({.body = coupling.head, .wrench = wrench});
  loads.push_back({.body = coupling.tail, .wrench = -1.0 * wrench});
}

FrictionLaw StateBalance::law_of(std::size_t friction,
                                 double sense,
                                 double rate,
                                 bool at_rest,
                                 const std::function<bool(CouplingId)>& slips) const {
  const Rubbing& one = (at_rest ? resting_ : sliding_)[friction];
  const Twist& unit = moved_.geometry.motions[at(one.slides.front().freedom)];
  // Never so slow that it has no sense.
  const double size = std::max(sense * rate, std::numeric_limits<double>::min());
  if (one.gear) {
    return law_of_teeth(one, unit, sense, size);
  }
  // Arcs of cables on pulleys change as they move.
  CouplingFriction now = one.friction;
  now.cables = moved_.frictions[friction].cables;
  return make_friction_law(SlidingOf<double>{
      .topology = mechanism_.topology,
      .friction = now,
      .unit = unit,
      .twist = {.angular = sense * size * unit.angular, .linear = sense * size * unit.linear},
      .at = moved_.geometry.points[at(one.coupling.value)],
      .unit_action = [&](int a) { return moved_.geometry.actions[at(a)]; },
      .slips = slips});
}

BodyPair StateBalance::rubbed_bodies(const FrictionLaw& law) const {
  const CouplingTopology& coupling = mechanism_.topology.coupling(law.coupling);
  return law.between.value_or(BodyPair{.tail = coupling.tail, .head = coupling.head});
}

FrictionMagnitudes StateBalance::solve_friction(std::span<const BodyWrench> loads,
                                                std::span<const FrictionLaw> laws,
                                                std::span<const std::vector<BodyWrench>> along) {
  std::vector<BodyWrench> outside(loads.begin(), loads.end());
  for (const FrictionLaw& law : laws) {
    outside.push_back({.body = rubbed_bodies(law).head, .wrench = law.unit});
  }
  const CoordinateBasis basis = action_basis(moved_.geometry, moved_.static_order, outside);
  return solve_friction_balance({.mechanism = moved_,
                                 .basis = basis,
                                 .primaries = idle_,
                                 .loads = loads,
                                 .laws = laws,
                                 .along = along});
}

// Zero where they are rounding of what acts.
ForceOf StateBalance::tooth_forces(std::span<const std::optional<double>> magnitudes) const {
  return [=, this](int action) {
    return zero_within_bound(magnitudes[at(action)].value_or(0.0), kConsistency * largest_load_);
  };
}

// True if some press on another flank than those for which the magnitudes hold.
bool StateBalance::turn_flanks_under(std::span<const std::optional<double>> magnitudes) {
  std::vector<int> coast = coast_flanks_under(moved_.geometry, coast_, tooth_forces(magnitudes));
  if (coast == coast_) {
    return false;
  }
  load_coast_flanks(coast_, moved_.geometry);
  load_coast_flanks(coast, moved_.geometry);
  coast_ = std::move(coast);
  return true;
}

std::vector<int> StateBalance::pulling(std::span<const std::optional<double>> magnitudes) const {
  return pulling_teeth(moved_, coast_, tooth_forces(magnitudes));
}

std::vector<std::optional<Vec3>> StateBalance::reactions(
    std::span<const std::optional<double>> magnitudes,
    std::span<const std::optional<double>> friction,
    std::span<const BodyPose> poses) const {
  const Topology& topology = mechanism_.topology;
  const auto force_of = [&](CouplingId id) -> std::optional<Vec3> {
    const CouplingTopology& coupling = topology.coupling(id);
    Vec3 force = Vec3::Zero();
    for (int a = coupling.first_action; a < coupling.first_action + coupling.action_count; ++a) {
      if (topology.actions[at(a)].actuator >= 0) {
        continue;
      }
      if (!magnitudes[at(a)]) {
        return std::nullopt;
      }
      force += *magnitudes[at(a)] * moved_.geometry.actions[at(a)].force;
    }
    for (std::size_t i = 0; i < mechanism_.frictions.size(); ++i) {
      const int freedom = coupling.first_freedom;
      if (mechanism_.frictions[i].coupling == id && !topology.freedoms[at(freedom)].is_rotation) {
        if (!friction[i]) {
          return std::nullopt;
        }
        force += *friction[i] * moved_.geometry.motions[at(freedom)].linear;
      }
    }
    return force;
  };
  std::vector<std::optional<Vec3>> forces;
  for (const CouplingReaction& one : reactions_) {
    forces.push_back(resultant_force(one, topology, poses, force_of));
  }
  return forces;
}

// Forces, and couples over the size of the mechanism.
void StateBalance::note_largest(std::span<const BodyWrench> loads) {
  largest_load_ = 0.0;
  for (const BodyWrench& load : loads) {
    largest_load_ = std::max({largest_load_,
                              load.wrench.force.norm(),
                              load.wrench.moment.norm() / moved_.geometry.length});
  }
}

bool StateBalance::turn_flanks(std::span<const BodyWrench> loads) {
  note_largest(loads);
  return !moved_.geometry.other_flanks.empty() && turn_flanks_under(solve_on_flanks(loads));
}

std::vector<std::optional<double>> StateBalance::solve(std::span<const BodyWrench> loads) {
  note_largest(loads);
  std::vector<std::optional<double>> magnitudes = solve_on_flanks(loads);
  const std::size_t most_rounds = 2 * moved_.geometry.other_flanks.size();
  for (std::size_t i = 0; i < most_rounds && turn_flanks_under(magnitudes); ++i) {
    magnitudes = solve_on_flanks(loads);
  }
  return magnitudes;
}

std::vector<std::optional<double>> StateBalance::solve_on_flanks(
    std::span<const BodyWrench> loads) const {
  const CoordinateBasis basis = action_basis(moved_.geometry, moved_.static_order, loads);
  const StaticSolution found =
      resolve_indeterminacy(moved_, basis, idle_, loads, solve_action(moved_, basis, idle_, loads));
  if (found.status == SolveStatus::inconsistent) {
    return solve_with_rounding(basis, loads);
  }
  std::vector<std::optional<double>> magnitudes = found.magnitudes;
  magnitudes.resize(mechanism_.topology.actions.size());
  return magnitudes;
}

// The accelerations keep the equations of motion, so that loads in which they are contradict
// nothing. Where little is borne, what rounding leaves of large loads is yet more than a share of
// it.
std::vector<std::optional<double>> StateBalance::solve_with_rounding(
    const CoordinateBasis& basis, std::span<const BodyWrench> loads) const {
  std::vector<int> known;
  for (const Primary& one : idle_) {
    known.push_back(one.index);
  }
  const std::vector<double> zeros(known.size(), 0.0);
  const Equilibrium equilibrium(moved_, basis, std::move(known), {});
  const VecX found = equilibrium.solve(zeros, loads).magnitudes;
  std::vector<std::optional<double>> magnitudes(found.begin(), found.end());
  for (const int open : equilibrium.check(loads).undetermined) {
    magnitudes[at(open)] = std::nullopt;
  }
  return magnitudes;
}

}  // namespace kinestat
