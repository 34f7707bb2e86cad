#include "cases/solve_cases.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cases/case_passes.hpp"
#include "cases/converter_slip.hpp"
#include "cases/exact_input_cases.hpp"
#include "cases/idle_freedoms.hpp"
#include "cases/moving_loads.hpp"
#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "kinematics/velocity.hpp"
#include "mechanism/bind/bind.hpp"
#include "mechanism/gears/coast_flanks.hpp"
#include "network/bases.hpp"
#include "power/tooth_ratio.hpp"
#include "statics/action.hpp"
#include "statics/coupling_wrenches.hpp"
#include "statics/friction_solve.hpp"
#include "statics/indeterminacy.hpp"
#include "statics/one_sided_action.hpp"
#include "statics/pretension.hpp"

namespace kinestat {

namespace {

bool is_solved(const std::optional<KinematicSolution>& motion) {
  return motion && motion->status == SolveStatus::solved;
}

bool has_answer(const std::optional<StaticSolution>& action) {
  return action && !action->magnitudes.empty();
}

// Whether anybody asked for statics: a case, or a file without cases, which asks for the counts.
bool wants_statics(const Mechanism& mechanism) {
  return mechanism.cases.empty() ||
         std::ranges::any_of(mechanism.cases, [](const Case& c) { return c.asks_actions; });
}

MobilityCounts counts_of(const MechanismDescription& description, const Mechanism& mechanism) {
  const bool has_actions = wants_statics(mechanism);
  std::optional<Mechanism> in_space;
  if (mechanism.space == Space::planar && (has_actions || frees_more_in_space(description))) {
    // It complains of nothing that the first binding did not, and that had no errors.
    Diagnostics ignored;
    in_space = bind_in_space(description, ignored);
    KINESTAT_EXPECTS(in_space.has_value());
  }
  const Mechanism& spatial = in_space ? *in_space : mechanism;
  MobilityCounts counts = count_motions(mechanism, spatial);
  if (has_actions) {
    count_actions(mechanism, spatial, counts);
  }
  return counts;
}

// The coordinates of both sides are the same for every case, unless its loads need more.
struct Bases {
  CoordinateBasis motion;
  CoordinateBasis action;
};

// Where a cable does not slip, the couple of an actuator holds it: its size is an action. A pulley
// that stands with a cable that may slip has none of its own.
bool is_held(const Mechanism& mechanism, const CouplingFriction& friction) {
  const bool is_cable_alone = !friction.cables.empty() && friction.mu == 0.0 &&
                              friction.tau == 0.0 && friction.viscous == 0.0;
  const Topology& topology = mechanism.topology;
  const bool may_slip = std::ranges::all_of(
      friction.cables, [](const CableFriction& cable) { return cable.unless_slip.has_value(); });
  return is_cable_alone &&
         (may_slip ||
          std::ranges::any_of(topology.actuators, [&](const ActuatorTopology& actuator) {
            const auto freedom = static_cast<std::size_t>(actuator.freedom);
            return topology.freedoms[freedom].coupling == friction.coupling;
          }));
}

// The frictions of a case, and the couplings where it has no direction.
struct Frictions {
  std::vector<FrictionLaw> laws;
  std::vector<CouplingId> at_rest;
  std::vector<CouplingId> held_cables;
};

Frictions find_frictions(const Mechanism& mechanism,
                         const Case& which,
                         const KinematicSolution* motion) {
  Frictions result;
  const auto found = motion != nullptr
                         ? find_friction_laws(mechanism, which, *motion)
                         : std::vector<std::optional<FrictionLaw>>(mechanism.frictions.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const CouplingTopology& coupling = mechanism.topology.coupling(mechanism.frictions[i].coupling);
    if (found[i] && motion->knows_rate(coupling.first_freedom)) {
      result.laws.push_back(*found[i]);
    } else {
      std::vector<CouplingId>& couplings =
          is_held(mechanism, mechanism.frictions[i]) ? result.held_cables : result.at_rest;
      couplings.push_back(mechanism.frictions[i].coupling);
    }
  }
  return result;
}

// Friction that knows no direction leaves the actions open.
StaticSolution without_direction(StaticSolution solution, std::vector<CouplingId> at_rest) {
  solution.status = SolveStatus::at_rest;
  solution.at_rest = std::move(at_rest);
  solution.magnitudes.clear();
  solution.wrenches.clear();
  return solution;
}

// Loads and frictions may leave the coordinates that the actions need.
CoordinateBasis basis_for(const Mechanism& mechanism,
                          const CoordinateBasis& common,
                          std::vector<BodyWrench> outside,
                          const std::vector<FrictionLaw>& laws) {
  for (const FrictionLaw& law : laws) {
    outside.push_back({.body = mechanism.topology.coupling(law.coupling).head, .wrench = law.unit});
  }
  return action_basis(common, mechanism.geometry, outside);
}

// How much of a case is worked out.
enum class CasePasses {
  magnitudes,  // rates and actions alone
  row,         // no power graph, unless the losses of meshes need it
  all
};

// What is asked of a case beside its own numbers.
struct CaseRequest {
  const Case& which;
  const AccuracyRequest& accuracy;
  ExactInputCases* exact_input = nullptr;  // of all cases; null where none are wanted
  std::size_t index = 0;                   // among these
  CaseCertainty* certainty = nullptr;      // filled in beside `exact_input`
  CasePasses passes = CasePasses::all;
  const KinematicSolution* motion = nullptr;  // null: to be solved
  const InertialMotion* inertial = nullptr;   // of a case with inertia; null: as drawn
  const LoadState* place = nullptr;           // null: as drawn
};

// Friction is followed in doubles: there is no bound for it.
StaticSolution solve_statics(const Mechanism& mechanism,
                             const CoordinateBasis& common,
                             const Case& which,
                             const AccuracyRequest& accuracy,
                             const KinematicSolution* motion) {
  const std::vector<BodyWrench> loads = wrenches_of(which.loads);
  Frictions frictions = find_frictions(mechanism, which, motion);
  const CoordinateBasis basis = basis_for(mechanism, common, loads, frictions.laws);
  if (!frictions.at_rest.empty()) {
    return without_direction(solve_action(mechanism, basis, which.actions, loads),
                             std::move(frictions.at_rest));
  }
  StaticSolution solution =
      frictions.laws.empty()
          ? solve_action(mechanism, basis, which.actions, loads, accuracy)
          : solve_with_friction(mechanism, basis, which.actions, loads, frictions.laws);
  solution.held_cables = std::move(frictions.held_cables);
  return resolve_indeterminacy(mechanism, basis, which.actions, loads, std::move(solution));
}

// The mechanism with the flanks on which the teeth press in a case, and its actions.
struct LoadedFlanks {
  std::vector<int> turned;
  std::optional<Mechanism> mechanism;  ///< empty if none is turned
  CoordinateBasis basis = {};
  StaticSolution action = {};
};

std::vector<int> find_coast_flanks(const Geometry& geometry, const LoadedFlanks& now) {
  return coast_flanks_under(geometry, now.turned, [&](int action) {
    const bool is_known = now.action.magnitudes[static_cast<std::size_t>(action)].has_value();
    return is_known ? bounded_action(now.action, action).zeroed() : 0.0;
  });
}

LoadedFlanks solve_on_flanks(const Mechanism& drawn,
                             const Bases& bases,
                             const Case& which,
                             const AccuracyRequest& accuracy,
                             const KinematicSolution* motion,
                             std::vector<int> turned) {
  LoadedFlanks result{.turned = std::move(turned), .mechanism = {}, .basis = bases.action};
  if (!result.turned.empty()) {
    result.mechanism = drawn;
    load_coast_flanks(result.turned, result.mechanism->geometry);
    result.basis = action_basis(result.mechanism->geometry, drawn.static_order);
  }
  result.action = solve_statics(
      result.mechanism ? *result.mechanism : drawn, result.basis, which, accuracy, motion);
  return result;
}

// Torques decide on the flanks wherever equilibrium does, and the second answer is the last; it may
// take more where bearings have friction, or where wheels are not held by hinges. Friction under
// which no flanks fit their forces lets nothing move; without it the case is that of the flanks as
// drawn, of which the findings say that they do not fit.
LoadedFlanks solve_on_loaded_flanks(const Mechanism& drawn,
                                    const Bases& bases,
                                    const Case& which,
                                    const AccuracyRequest& accuracy,
                                    const KinematicSolution* motion) {
  LoadedFlanks result = solve_on_flanks(drawn, bases, which, accuracy, motion, {});
  const std::size_t most_rounds = 2 * drawn.geometry.other_flanks.size();
  for (std::size_t i = 0; i < most_rounds && !result.action.magnitudes.empty(); ++i) {
    std::vector<int> turned = find_coast_flanks(drawn.geometry, result);
    if (turned == result.turned) {
      return result;
    }
    result = solve_on_flanks(drawn, bases, which, accuracy, motion, std::move(turned));
  }
  const bool fits = result.action.magnitudes.empty() || most_rounds == 0 ||
                    find_coast_flanks(drawn.geometry, result) == result.turned;
  const bool loses_answer = !result.turned.empty() && result.action.magnitudes.empty();
  if ((!fits || loses_answer) && drawn.frictions.empty()) {
    return solve_on_flanks(drawn, bases, which, accuracy, motion, {});
  }
  if (!fits) {
    result.action.status = SolveStatus::locked_by_friction;
    result.action.magnitudes.clear();
    result.action.wrenches.clear();
  }
  return result;
}

// The case gets what is assumed of freedoms that no body feels.
KinematicSolution solve_motion_of(const Mechanism& mechanism,
                                  const CoordinateBasis& basis,
                                  const AccuracyRequest& accuracy,
                                  Case& which) {
  KinematicSolution motion = solve_velocity(mechanism, basis, which.motions, accuracy);
  if (motion.status != SolveStatus::underdetermined) {
    return motion;
  }
  std::vector<IdleFreedom> idle = hold_idle_freedoms(mechanism, basis, motion, which);
  if (idle.empty()) {
    idle = hold_beside_gear(mechanism, basis, motion, which);
  }
  if (!idle.empty()) {
    motion = solve_velocity(mechanism, basis, which.motions, accuracy);
    motion.idle = std::move(idle);
  }
  return motion;
}

CaseAnalysis solve_case(const Mechanism& drawn, const Bases& bases, const CaseRequest& request);

// Where the motion leaves a converter open whose torque is known: the case with its slip, else with
// what the search says.
std::optional<CaseAnalysis> solve_by_converter(const Mechanism& drawn,
                                               const Bases& bases,
                                               const CaseRequest& request,
                                               CaseAnalysis& open) {
  if (!open.which.asks_actions || open.motion->status != SolveStatus::underdetermined) {
    return std::nullopt;
  }
  std::optional<ConverterSearch> search =
      find_converter_slip(drawn, bases.motion, request.which, [&](const Case& one) {
        return solve_case(
            drawn,
            bases,
            {.which = one, .accuracy = request.accuracy, .passes = CasePasses::magnitudes});
      });
  if (!search || !search->which) {
    open.converter_search = std::move(search);
    return std::nullopt;
  }
  CaseRequest closed{
      .which = *search->which, .accuracy = request.accuracy, .passes = request.passes};
  CaseAnalysis result = solve_case(drawn, bases, closed);
  result.converter_search = std::move(search);
  return result;
}

// Of loads that are themselves results of doubles, such as forces of inertia: more digits would
// tell their roundings from zero.
AccuracyRequest of_doubles(AccuracyRequest asked) {
  if (asked.accuracy == Accuracy::exact || asked.accuracy == Accuracy::high) {
    asked.accuracy = Accuracy::automatic;
  }
  return asked;
}

CaseAnalysis solve_case(const Mechanism& drawn, const Bases& bases, const CaseRequest& request) {
  CaseAnalysis result;
  result.which = request.which;
  const Case& which = result.which;
  if (which.asks_motions && request.motion != nullptr) {
    result.motion = *request.motion;
  } else if (which.asks_motions) {
    result.motion = solve_motion_of(drawn, bases.motion, request.accuracy, result.which);
    if (std::optional<CaseAnalysis> closed = solve_by_converter(drawn, bases, request, result)) {
      return *std::move(closed);
    }
  }
  if (result.motion && request.exact_input != nullptr) {
    request.certainty->has_exact_input_motion =
        request.exact_input->improve(request.index, which.motions, *result.motion);
  }
  const KinematicSolution* motion = is_solved(result.motion) ? &*result.motion : nullptr;
  if (which.asks_actions && (which.follows_curves() || !drawn.springs.empty())) {
    add_placed_loads(drawn, request.place, result);
  }
  const InertialMotion* inertial = which.has_inertia() ? request.inertial : nullptr;
  std::optional<InertialMotion> as_drawn;
  if (which.has_inertia() && inertial == nullptr) {
    as_drawn = drawn_inertial_motion(drawn, result);
    inertial = as_drawn ? &*as_drawn : nullptr;
  }
  if (inertial != nullptr) {
    add_inertial_loads(drawn, *inertial, result);
  }
  LoadedFlanks flanks;
  if (which.asks_actions && !result.has_unknown_loads()) {
    const bool are_typed = has_typed_loads(request.which, which);
    flanks = solve_on_loaded_flanks(
        drawn, bases, which, are_typed ? request.accuracy : of_doubles(request.accuracy), motion);
    if (request.exact_input != nullptr && are_typed &&
        find_frictions(drawn, which, motion).laws.empty()) {
      request.certainty->has_exact_input_action =
          request.exact_input->improve(request.index,
                                       flanks.mechanism ? *flanks.mechanism : drawn,
                                       flanks.turned,
                                       result.motion ? &*result.motion : nullptr,
                                       flanks.action);
    }
    if (request.exact_input != nullptr && motion != nullptr) {
      request.exact_input->improve_beside(
          request.index, which.motions, flanks.action, *result.motion);
    }
    result.action = std::move(flanks.action);
    result.coast_flanks = std::move(flanks.turned);
  }
  if (request.passes == CasePasses::magnitudes) {
    return result;
  }
  const Mechanism& mechanism = flanks.mechanism ? *flanks.mechanism : drawn;
  if (inertial != nullptr) {
    result.dynamics =
        find_dynamics(mechanism, which, *inertial, result.action ? &*result.action : nullptr);
  }
  if (has_answer(result.action)) {
    result.contacts = find_cable_contact_states(
        mechanism, *result.action, is_solved(result.motion) ? &*result.motion : nullptr);
    if (is_solved(result.motion)) {
      result.converters = find_converter_states(mechanism, *result.motion);
    }
    if (!find_pushed_segments(mechanism, *result.action).empty()) {
      result.pretension = find_pretension(mechanism, flanks.basis, *result.action);
    }
  }
  if (is_solved(result.motion) && has_answer(result.action) &&
      determines_power(mechanism, *result.action)) {
    result.power = find_power(mechanism, which, *result.motion, *result.action);
    const bool has_losses = !mechanism.lossy_meshes.empty();
    if (has_losses || request.passes == CasePasses::all) {
      result.power_graph =
          find_power_graph(mechanism, which, *result.motion, *result.action, *result.power);
    }
    if (has_losses) {
      result.efficiency = find_transmission_efficiency(mechanism,
                                                       bases.action,
                                                       {.which = which,
                                                        .motion = *result.motion,
                                                        .power = *result.power,
                                                        .graph = *result.power_graph});
    }
  }
  if (is_solved(result.motion) && has_ratio_ends(which)) {
    result.ratios = find_ratios(
        mechanism, which, *result.motion, has_answer(result.action) ? &*result.action : nullptr);
  }
  return result;
}

void add_fraction(const MechanismDescription& description,
                  const Mechanism& mechanism,
                  CaseAnalysis& one) {
  if (one.ratios && one.ratios->ratio) {
    const std::optional<Rational> exact =
        tooth_ratio(description, mechanism, one.which, *one.ratios->ratio);
    one.ratios->fraction = exact ? exact->str() : "";
  }
}

Bases bases_of(const Mechanism& mechanism) {
  return {.motion = motion_basis(mechanism.geometry, mechanism.kinematic_order),
          .action = action_basis(mechanism.geometry, mechanism.static_order)};
}

}  // namespace

std::vector<CaseAnalysis> solve_some_cases(const Mechanism& mechanism,
                                           std::span<const Case> wanted,
                                           const AccuracyRequest& request) {
  const Bases bases = bases_of(mechanism);
  std::vector<CaseAnalysis> cases;
  for (const Case& which : wanted) {
    cases.push_back(solve_case(mechanism, bases, {.which = which, .accuracy = request}));
  }
  return cases;
}

std::vector<CaseAnalysis> solve_magnitudes(const Mechanism& mechanism) {
  const Bases bases = bases_of(mechanism);
  const AccuracyRequest usual;
  std::vector<CaseAnalysis> cases;
  for (const Case& which : mechanism.cases) {
    cases.push_back(solve_case(
        mechanism, bases, {.which = which, .accuracy = usual, .passes = CasePasses::magnitudes}));
  }
  return cases;
}

CaseAnalysis solve_row(const Mechanism& mechanism, const Case& which, const KnownState& known) {
  const AccuracyRequest usual;
  return solve_case(mechanism,
                    bases_of(mechanism),
                    {.which = which,
                     .accuracy = usual,
                     .passes = CasePasses::row,
                     .motion = known.motion,
                     .inertial = known.inertial,
                     .place = known.place});
}

CaseAnalysis solve_certified_case(const MechanismDescription& description,
                                  const Mechanism& mechanism,
                                  std::size_t index,
                                  const Case& which) {
  const AccuracyRequest request{.accuracy = Accuracy::automatic};
  ExactInputCases exact_input(description, mechanism, request);
  CaseCertainty certainty;
  return solve_case(mechanism,
                    bases_of(mechanism),
                    {.which = which,
                     .accuracy = request,
                     .exact_input = &exact_input,
                     .index = index,
                     .certainty = &certainty});
}

Analysis solve_cases(std::string file, Loaded loaded, const AccuracyRequest& request) {
  return solve_certified_cases(std::move(file), std::move(loaded), request).analysis;
}

CertifiedAnalysis solve_certified_cases(std::string file,
                                        Loaded loaded,
                                        const AccuracyRequest& request) {
  CertifiedAnalysis result;
  Analysis& analysis = result.analysis;
  analysis.file = std::move(file);
  analysis.shift = std::move(loaded.shift);
  analysis.description = std::move(loaded.description);
  analysis.mechanism = std::move(loaded.mechanism);
  const Mechanism& mechanism = analysis.mechanism;
  ExactInputCases exact_input(analysis.description, mechanism, request);
  analysis.mobility = counts_of(analysis.description, mechanism);
  result.certainty.accuracy = request;
  result.certainty.cases.resize(mechanism.cases.size());
  const Bases bases = bases_of(mechanism);
  for (std::size_t c = 0; c < mechanism.cases.size(); ++c) {
    analysis.cases.push_back(solve_case(mechanism,
                                        bases,
                                        {.which = mechanism.cases[c],
                                         .accuracy = request,
                                         .exact_input = &exact_input,
                                         .index = c,
                                         .certainty = &result.certainty.cases[c]}));
    add_fraction(analysis.description, mechanism, analysis.cases.back());
  }
  if (request.accuracy != Accuracy::fast) {
    exact_input.find_ranks(analysis.mobility.minimal.actions.has_value(), result.certainty);
    exact_input.count_exact_input(result.certainty, analysis.mobility);
  }
  return result;
}

}  // namespace kinestat
