#include "power/transmission_efficiency.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/tolerance.hpp"
#include "network/bases.hpp"
#include "power/absolute_efficiency.hpp"
#include "power/internal/no_efficiency.hpp"
#include "statics/lossy_actions.hpp"

namespace kinestat {

namespace {

Efficiency self_locking(std::string reason) {
  return {.value = std::nullopt, .reason = std::move(reason), .is_self_locking = true};
}

// The other end drives: all runs back under the same actions and loads, so that whatever holds in
// one direction only still does, such as the tension of a cable and the flanks of teeth.
Case driven_back(Case which) {
  std::swap(which.inputs, which.outputs);
  std::swap(which.input_loads, which.output_loads);
  return which;
}

KinematicSolution run_back(KinematicSolution motion) {
  const auto turn = [](Twist& twist) { twist = -1.0 * twist; };
  for (double& rate : motion.rates) {
    rate = -rate;
  }
  std::ranges::for_each(motion.bodies, turn);
  std::ranges::for_each(motion.couplings, turn);
  return motion;
}

// Where a cable does not slip there is none: its friction is an action, as the case without losses
// found.
std::vector<FrictionLaw> friction_laws(const Mechanism& mechanism,
                                       const Case& which,
                                       const KinematicSolution& motion) {
  std::vector<FrictionLaw> laws;
  for (const std::optional<FrictionLaw>& law : find_friction_laws(mechanism, which, motion)) {
    if (law) {
      laws.push_back(*law);
    }
  }
  return laws;
}

// A case, solved with its losses.
struct LossySolution {
  LossSearch search = LossSearch::none;
  StaticSolution action;
  std::optional<PowerFlow> flow;     ///< where the actions determine it
  std::optional<double> other = {};  ///< the efficiency of another answer
};

// One direction of a case.
class LossyCase {
 public:
  LossyCase(const Mechanism& mechanism,
            const CoordinateBasis& common,
            const Case& which,
            const KinematicSolution& motion,
            const std::vector<MeshLossLaw>& meshes)
      : mechanism_(mechanism),
        which_(which),
        motion_(motion),
        meshes_(meshes),
        frictions_(friction_laws(mechanism, which, motion)),
        basis_(basis_for(common)) {}

  LossySolution solve() const {
    const std::vector<BodyWrench> loads = wrenches_of(which_.loads);
    LossyActions found = solve_with_losses(
        mechanism_,
        basis_,
        {.primaries = which_.actions, .loads = loads, .frictions = frictions_, .meshes = meshes_},
        [&](const VecX& actions) { return passes_on(actions); });
    LossySolution result{.search = found.search, .action = std::move(found.solution), .flow = {}};
    if (determines_power(mechanism_, result.action)) {
      result.flow = find_power(mechanism_, which_, motion_, result.action);
    }
    if (found.other && determines_power(mechanism_, *found.other)) {
      const PowerFlow flow = find_power(mechanism_, which_, motion_, *found.other);
      result.other = between_ends(flow).value;
    }
    return result;
  }

  Efficiency efficiency_of(const LossySolution& solution) const {
    if (!which_.names_both_ends()) {
      return no_efficiency("the case does not name input and output");
    }
    if (solution.search == LossSearch::undecided) {
      return no_efficiency(fmt::format(
          "which gears drive could not be found, with more than {} meshes", kMostSearchedMeshes));
    }
    if (solution.search == LossSearch::no_share) {
      return no_efficiency(
          "a loss of teeth that depends on speed or force has no value there from 0 to below 1");
    }
    if (solution.action.magnitudes.empty()) {
      return self_locking("losses exceed the power of the inputs");
    }
    if (!solution.flow) {
      return no_efficiency("equilibrium does not determine the normal forces where power is lost");
    }
    const PowerFlow& flow = *solution.flow;
    if (!flow.is_balanced) {
      return no_efficiency("the powers do not balance");
    }
    Efficiency result = between_ends(flow);
    if (result.is_self_locking) {
      return self_locking("losses exceed the power of the inputs");
    }
    if (result.value && *result.value == 0.0) {
      if (gives_outputs()) {
        return {.value = 0.0, .reason = "no power leaves by the outputs"};
      }
      return {
          .value = 0.0, .reason = "losses absorb all power of the inputs", .is_self_locking = true};
    }
    if (result.value && solution.other) {
      result.other = solution.other;
      result.reason = fmt::format(
          "teeth that are driven the other way agree with their powers too, with an efficiency of "
          "{:.6g}",
          *solution.other);
    }
    return result;
  }

 private:
  Efficiency between_ends(const PowerFlow& flow) const {
    return find_efficiency(
        mechanism_.topology,
        which_,
        {.actuators = flow.actuators, .loads = flow.loads, .largest = flow.largest});
  }

  // Whether the case says what all outputs take, so that losses do not decide it.
  bool gives_outputs() const {
    return std::ranges::all_of(which_.outputs, [this](int output) {
      const int action = mechanism_.topology.actuators[static_cast<std::size_t>(output)].action;
      return std::ranges::find(which_.actions, action, &Primary::index) != which_.actions.end();
    });
  }

  // Loads and frictions may leave the coordinates that the actions need.
  CoordinateBasis basis_for(const CoordinateBasis& common) const {
    const std::vector<BodyWrench> loads = wrenches_of(which_.loads);
    const bool is_common = loads.empty() && frictions_.empty() && meshes_.empty();
    return is_common ? common
                     : lossy_action_basis(mechanism_,
                                          {.primaries = which_.actions,
                                           .loads = loads,
                                           .frictions = frictions_,
                                           .meshes = meshes_});
  }

  // Whether power leaves by the outputs, of those that the case names.
  bool passes_on(const VecX& actions) const {
    if (!which_.names_both_ends()) {
      return true;
    }
    double out = 0.0;
    double largest = 0.0;
    for (std::size_t i = 0; i < mechanism_.topology.actuators.size(); ++i) {
      const ActuatorTopology& actuator = mechanism_.topology.actuators[i];
      const double power =
          actions[actuator.action] * motion_.rates[static_cast<std::size_t>(actuator.freedom)];
      largest = std::max(largest, std::abs(power));
      out += std::ranges::count(which_.outputs, static_cast<int>(i)) > 0 ? power : 0.0;
    }
    for (std::size_t i = 0; i < which_.loads.size(); ++i) {
      const BodyWrench& acts = which_.loads[i].acts;
      const double gives =
          power(acts.wrench, motion_.bodies[static_cast<std::size_t>(acts.body.value)]);
      largest = std::max(largest, std::abs(gives));
      out += std::ranges::count(which_.output_loads, i) > 0 ? gives : 0.0;
    }
    return out < -kPowerBalance * largest;
  }

  const Mechanism& mechanism_;
  const Case& which_;
  const KinematicSolution& motion_;
  const std::vector<MeshLossLaw>& meshes_;
  std::vector<FrictionLaw> frictions_;
  CoordinateBasis basis_;
};

// The losses of the friction that acts between a gear and its carrier, at their meshes.
LossyState state_of(const Mechanism& mechanism,
                    const LossySolution& solution,
                    const MeshLossLaws& losses) {
  LossyState state;
  for (const LossyMesh& mesh : mechanism.lossy_meshes) {
    MeshLossPower one;
    one.mesh = mesh.coupling;
    one.rolls = std::ranges::count(losses.not_rolling, mesh.coupling) == 0;
    state.meshes.push_back(one);
  }
  const PowerFlow& flow = *solution.flow;
  double sum = 0.0;
  double largest = 0.0;
  const auto count = [&](double power) {
    sum += power;
    largest = std::max(largest, std::abs(power));
  };
  for (std::size_t i = 0; i < flow.friction.size(); ++i) {
    const FrictionAction& friction = solution.action.friction[i];
    count(flow.friction[i]);
    if (!friction.between) {
      state.friction.push_back(flow.friction[i]);
      continue;
    }
    MeshLossPower& mesh = *std::ranges::find(state.meshes, friction.coupling, &MeshLossPower::mesh);
    if (friction.magnitude > 0.0) {
      mesh.driven = friction.between->head;
      mesh.couple = friction.magnitude;
      mesh.power = flow.friction[i];
    }
  }
  std::ranges::for_each(flow.actuators, count);
  std::ranges::for_each(flow.loads, count);
  state.actions = solution.action.magnitudes;
  state.actuators = flow.actuators;
  state.input = flow.input;
  state.balance_residual = largest == 0.0 ? 0.0 : std::abs(sum) / largest;
  return state;
}

Efficiency absolute_of(const Mechanism& mechanism, const SolvedCase& solved) {
  if (!solved.which.names_both_ends()) {
    return no_efficiency("the case does not name input and output");
  }
  const PowerFlow& power = solved.power;
  Efficiency result = find_efficiency(
      mechanism.topology,
      solved.which,
      {.actuators = power.actuators, .loads = power.loads, .largest = power.largest});
  if (!result.value) {
    return result;
  }
  if (std::ranges::any_of(mechanism.lossy_meshes,
                          [](const LossyMesh& mesh) { return mesh.law.has_value(); })) {
    return no_efficiency("the absolute model does not cover losses that depend on speed or force");
  }
  if (!solved.which.input_loads.empty() || !solved.which.output_loads.empty()) {
    return no_efficiency("the absolute model does not cover a load as input or output");
  }
  const std::optional<double> value =
      find_absolute_efficiency(mechanism, solved.which, power, solved.graph);
  return value ? Efficiency{.value = value, .reason = ""}
               : no_efficiency("the powers of some bodies are not determined");
}

std::string plain_names(const Mechanism& mechanism, const std::vector<CouplingId>& couplings) {
  std::string text;
  for (const CouplingId coupling : couplings) {
    text += (text.empty() ? "'" : ", '") + mechanism.topology.coupling(coupling).name + "'";
  }
  return text;
}

}  // namespace

TransmissionEfficiency find_transmission_efficiency(const Mechanism& mechanism,
                                                    const CoordinateBasis& common,
                                                    const SolvedCase& solved) {
  TransmissionEfficiency result;
  result.absolute = absolute_of(mechanism, solved);
  const MeshLossLaws losses = find_mesh_loss_laws(mechanism, solved.motion);
  result.without_carrier = losses.without_carrier;
  if (!losses.without_carrier.empty()) {
    result.carrier =
        no_efficiency("no carrier is known of " + plain_names(mechanism, losses.without_carrier));
    result.carrier_backward = result.carrier;
    return result;
  }
  const LossyCase forward(mechanism, common, solved.which, solved.motion, losses.laws);
  const LossySolution solution = forward.solve();
  result.carrier = forward.efficiency_of(solution);
  if (solution.flow) {
    result.state = state_of(mechanism, solution, losses);
  }
  const Case case_back = driven_back(solved.which);
  const KinematicSolution motion_back = run_back(solved.motion);
  const MeshLossLaws losses_back = find_mesh_loss_laws(mechanism, motion_back);
  const LossyCase backward(mechanism, common, case_back, motion_back, losses_back.laws);
  result.carrier_backward = backward.efficiency_of(backward.solve());
  return result;
}

}  // namespace kinestat
