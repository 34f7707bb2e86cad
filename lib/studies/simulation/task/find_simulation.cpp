#include "studies/simulation/task/find_simulation.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/index.hpp"
#include "dynamics/inertial_motion.hpp"
#include "mechanism/bind/bind.hpp"
#include "mechanism/couplings/drawn_coupling_binder.hpp"
#include "mechanism/label_kind.hpp"
#include "report/number_format.hpp"
#include "studies/motion/configuration.hpp"
#include "studies/motion/motion.hpp"
#include "studies/simulation/task/read_simulation.hpp"

namespace kinestat {

namespace {

// Where the mechanism begins, and with which speeds of all joints.
struct Beginning {
  MotionNetwork network;
  Configuration configuration = {};
  std::vector<int> coordinates = {};  // rates of joints
  VecX rates = {};
};

class StartFinder {
 public:
  StartFinder(const Mechanism& mechanism, const SimulationPlan& plan, Diagnostics& found)
      : mechanism_(mechanism), topology_(mechanism.topology), plan_(plan), found_(found) {}

  std::optional<Beginning> find(const std::vector<DrawnCoupling>& drawn) {
    const MotionNetwork network = make_motion_network(mechanism_, drawn, with_frictions(drawn));
    if (!check_movable(network) || !check_goals(network)) {
      return std::nullopt;
    }
    std::optional<std::vector<int>> driven = choose(network);
    if (!driven) {
      return std::nullopt;
    }
    Beginning begin{.network = with_drives(network, *driven)};
    begin.coordinates = *driven;
    return go_to_start(begin) ? std::optional(std::move(begin)) : std::nullopt;
  }

 private:
  // Freedoms that must be joints of the tree: those that are given, held or stopped.
  std::vector<int> named() const {
    std::vector<int> all;
    const auto add = [&](const NamedFreedom& one) {
      if (std::ranges::find(all, one.freedom) == all.end()) {
        all.push_back(one.freedom);
      }
    };
    for (const HeldFreedom& one : plan_.held) {
      add(one.of);
    }
    for (const SimulationStart& one : plan_.starts) {
      add(one.of);
    }
    for (const SimulationStop& one : plan_.stops) {
      add(one.of);
    }
    return all;
  }

  // And those that may stick, as far as no circuit closes in them.
  std::vector<int> with_frictions(const std::vector<DrawnCoupling>& drawn) const {
    std::vector<int> all = named();
    for (const Rubbing& one : find_rubbing(mechanism_)) {
      const int freedom = one.slides.front().freedom;
      if (one.slides.size() > 1 || !one.is_dry() || std::ranges::find(all, freedom) != all.end()) {
        continue;
      }
      all.push_back(freedom);
      if (!make_motion_network(mechanism_, drawn, all).is_movable()) {
        all.pop_back();
      }
    }
    return all;
  }

  std::string name_of(int freedom) const { return topology_.freedom_name(freedom); }

  bool check_movable(const MotionNetwork& network) {
    if (network.is_movable()) {
      return true;
    }
    const UnmovableCoupling& first = network.obstacles.front();
    const CouplingTopology& coupling = topology_.coupling(first.coupling);
    const bool is_circuit = first.why == MotionObstacle::drives_in_circuit;
    found_.error(
        is_circuit ? "E0517" : "E0507",
        coupling.where,
        is_circuit
            ? fmt::format("what 'simulation' names with '{}' moves in a circuit of its own",
                          coupling.name)
            : fmt::format("coupling '{}' cannot be moved: {}", coupling.name, reason_of(first.why)),
        is_circuit ? "name fewer freedoms in 'start', 'motion' and 'stops'" : "");
    return false;
  }

  // A goal that no row could tell would never be reached.
  bool check_goals(const MotionNetwork& network) {
    const auto positions = freedom_positions(network, mechanism_, drawn_configuration(network));
    for (const SimulationGoal& goal : plan_.goals) {
      if (!goal.is_speed && !positions[at(goal.of.freedom)]) {
        found_.error("E0517",
                     goal.of.where,
                     fmt::format("'{}' has no position that 'until' could wait for", goal.of.name),
                     "name a freedom about or along one axis, or a speed");
        return false;
      }
    }
    return true;
  }

  // The held ones, those that the start names, then what tells the motions apart best.
  std::optional<std::vector<int>> choose(const MotionNetwork& network) {
    JointFollower follower(network);
    const MatX motions = follower.free_motions(drawn_configuration(network));
    std::vector<int> first;
    for (const HeldFreedom& one : plan_.held) {
      if (!add_named(network, one.of, motions, first)) {
        return std::nullopt;
      }
    }
    for (const SimulationStart& one : plan_.starts) {
      if (!is_held(one.of.freedom) && !add_named(network, one.of, motions, first)) {
        return std::nullopt;
      }
    }
    for (const SimulationStop& one : plan_.stops) {
      if (rate_of_freedom(network, one.of.freedom) < 0) {
        refuse_freedom(one.of);
        return std::nullopt;
      }
    }
    std::vector<int> preferred = first;
    for (const ActuatorTopology& actuator : topology_.actuators) {
      const int rate = rate_of_freedom(network, actuator.freedom);
      if (rate >= 0 && std::ranges::find(preferred, rate) == preferred.end()) {
        preferred.push_back(rate);
      }
    }
    std::vector<int> chosen = independent_rates(network, motions, preferred);
    if (static_cast<Eigen::Index>(chosen.size()) < motions.cols()) {
      found_.error("E0516",
                   plan_.where,
                   "a simulation does not cover bodies that turn freely about a point",
                   "model the ball as couplings with one axis each, such as a universal and a "
                   "revolute");
      return std::nullopt;
    }
    if (chosen.size() == plan_.held.size()) {
      found_.error("E0517",
                   plan_.where,
                   motions.cols() == 0 ? "nothing can move in the drawn position"
                                       : "'motion' of 'simulation' holds everything that moves",
                   "'kinestat motion' moves a mechanism whose drives are given");
      return std::nullopt;
    }
    return chosen;
  }

  bool is_held(int freedom) const {
    return std::ranges::any_of(plan_.held,
                               [&](const HeldFreedom& one) { return one.of.freedom == freedom; });
  }

  void refuse_freedom(const NamedFreedom& of) {
    found_.error(
        "E0517",
        of.where,
        fmt::format("'{}' cannot be told from the other freedoms by its position", of.name),
        "name a freedom of a revolute or prismatic coupling");
  }

  bool add_named(const MotionNetwork& network,
                 const NamedFreedom& of,
                 const MatX& motions,
                 std::vector<int>& first) {
    const int rate = rate_of_freedom(network, of.freedom);
    if (rate < 0) {
      refuse_freedom(of);
      return false;
    }
    std::vector<int> with = first;
    with.push_back(rate);
    const std::vector<int> kept = independent_rates(network, motions, with);
    if (kept.size() < with.size() || kept[with.size() - 1] != rate) {
      std::string others;
      for (const int one : first) {
        for (const MotionJoint& joint : network.joints) {
          if (joint.rate == one) {
            others += (others.empty() ? "" : ", ") + name_of(joint.freedom);
          }
        }
      }
      found_.error("E0517",
                   of.where,
                   others.empty()
                       ? fmt::format("'{}' cannot move in the drawn position", of.name)
                       : fmt::format("'{}' follows from {}, which are given, too", of.name, others),
                   "give no more freedoms than are independent");
      return false;
    }
    first = with;
    return true;
  }

  bool go_to_start(Beginning& begin) {
    MotionTask task{.drives = {}, .steps = 1};
    std::vector<double> speeds;
    for (const int freedom : begin.network.driven_freedoms) {
      double position = 0.0;
      double speed = 0.0;
      for (const SimulationStart& one : plan_.starts) {
        if (one.of.freedom == freedom) {
          position = one.position;
          speed = one.speed;
        }
      }
      for (const HeldFreedom& one : plan_.held) {
        speed = one.of.freedom == freedom ? one.speed : speed;
      }
      task.drives.push_back({.freedom = freedom, .from = position, .to = position});
      const bool is_rotation = topology_.freedoms[at(freedom)].is_rotation;
      speeds.push_back(speed / (is_rotation ? 1.0 : begin.network.length));
    }
    const MotionSolution way = solve_motion(begin.network, task);
    if (way.position_count() == 0) {
      found_.error("E0517",
                   plan_.where,
                   way.status == MotionStatus::not_assembled ? "the drawn position does not close"
                   : way.status == MotionStatus::lost_branch || way.status == MotionStatus::limit
                       ? "the mechanism cannot come from the drawn position to the start"
                       : "the drawn position is singular: what is given does not determine it",
                   "'kinestat motion' with the same drives says more; draw the mechanism nearer to "
                   "the start, or begin elsewhere");
      return false;
    }
    begin.configuration = way.configuration_at(0);
    JointFollower follower(begin.network);
    const std::optional<MatX> units = follower.unit_rates(begin.configuration);
    if (!units) {
      found_.error("E0517",
                   plan_.where,
                   "the start is a singular position: speeds there are not determined",
                   "begin near it");
      return false;
    }
    if (const std::optional<BodyId> body = spinning_body(begin, speeds.size())) {
      found_.error("E0516",
                   topology_.body(*body).where,
                   fmt::format("body '{}' has an idle freedom, in which its inertia counts",
                               topology_.body(*body).name),
                   "a simulation does not cover that: remove this idle freedom, for example by a "
                   "universal joint instead of a ball");
      return false;
    }
    begin.rates =
        *units * Eigen::Map<const VecX>(speeds.data(), static_cast<Eigen::Index>(speeds.size()));
    return true;
  }

  // Whose inertia a motion would speed up that no other body feels.
  std::optional<BodyId> spinning_body(const Beginning& begin, std::size_t drives) const {
    MotionStates states(begin.network, mechanism_);
    const GivenSpeeds at_rest{.drives = std::vector<DriveSpeed>(drives), .passive = {}};
    const auto motion =
        find_inertial_motion(mechanism_, begin.network, states, begin.configuration, at_rest);
    const InertiaObstacle* const obstacle = std::get_if<InertiaObstacle>(&motion);
    return obstacle != nullptr ? obstacle->body : std::nullopt;
  }

  const Mechanism& mechanism_;
  const Topology& topology_;
  const SimulationPlan& plan_;
  Diagnostics& found_;
};

std::string name_of(const SimulationObstacle& obstacle, const Mechanism& mechanism) {
  using enum SimulationObstacle::Kind;
  const std::string rubbing =
      obstacle.coupling ? fmt::format("'{}'", mechanism.topology.coupling(*obstacle.coupling).name)
                        : "couplings that stick";
  switch (obstacle.kind) {
    case no_branch:
    case singular:
      return "the mechanism is in a singular position there, from which nothing says how it goes "
             "on";
    case no_inertia:
      return "something moves there that has neither mass nor inertia";
    case rotor:
      return fmt::format(
          "body '{}', of which only the inertia about one axis is known, turns about "
          "another",
          mechanism.topology.body(*obstacle.body).name);
    case spring:
      return fmt::format("spring '{}' has no force there",
                         mechanism.springs[obstacle.of_spring->spring].name);
    case curve:
      return obstacle.of_curve->kind == CurveObstacle::Kind::no_value
                 ? fmt::format("'{}' has no value there", obstacle.of_curve->number)
                 : fmt::format("curve '{}' has no value there",
                               mechanism.curves[obstacle.of_curve->curve].name);
    case friction_without_end:
      return fmt::format("friction of {} grows without end with what it causes", rubbing);
    case friction_in_two_ways:
      return fmt::format("friction of {} is in balance in two ways", rubbing);
    case open_friction:
      return fmt::format("nothing says how large the friction of {} is", rubbing);
    case stuck_in_circuit:
      return fmt::format("{} would stick alone while its circuit moves on", rubbing);
    case beyond_stop:
      return "a freedom begins beyond its stop";
    case no_progress:
      return "stops are struck again and again there, and nothing moves on";
    case no_step:
      return "the steps of the integration vanish there";
    case too_many_steps:
      return "its steps are too many; so fast is something against 'time'";
  }
  return "";
}

std::string_view hint_of(const SimulationObstacle& obstacle) {
  using enum SimulationObstacle::Kind;
  switch (obstacle.kind) {
    case no_branch:
    case singular:
      return "'stops' keep a freedom from going so far; end it earlier with 'until'";
    case no_inertia:
      return "give the bodies that move 'mass', 'centre_of_mass' and 'inertia'";
    case rotor:
      return "give three moments of inertia instead of {polar: …}";
    case spring:
      return "'kinestat explain E0324' says when; 'stops' keep a freedom from going so far";
    case curve:
      return "give the curve points as far, or a 'period'; 'kinestat explain E0326' says more";
    case friction_without_end:
    case friction_in_two_ways:
      return "rigid bodies with so much friction have no answer there (Painleve): make it less, or "
             "what presses longer";
    case open_friction:
      return "equilibrium does not determine the normal forces there, or how couplings that stick "
             "together share the load: leave to each what it takes, or the friction to one of them";
    case stuck_in_circuit:
      return "name it in 'start', so that it is a coordinate; or leave the friction to another "
             "coupling of its circuit";
    case beyond_stop:
      return "give it a place within, or a stop further out: both are from the drawn position";
    case no_progress:
      return "stops that press on each other through what they stop are not told apart: leave one "
             "of them";
    case no_step:
      return "something becomes infinitely fast there; end it earlier with 'until'";
    case too_many_steps:
      return "make the time shorter, what is stiff softer or what moves there heavier, or raise "
             "'tolerance'";
  }
  return "";
}

// How near a simulation came to a goal that lies beyond all of its rows.
struct NearestRow {
  bool is_greatest = true;
  double value = 0.0;
  double time = 0.0;
};

std::optional<NearestRow> nearest_row(const SimulationGoal& goal, const SimulationSolution& of) {
  std::optional<NearestRow> nearest;
  for (const SimulationRow& row : of.rows) {
    const std::optional<double>& value =
        goal.is_speed ? row.rates[at(goal.of.freedom)] : row.positions[at(goal.of.freedom)];
    if (!value) {
      continue;
    }
    if (*value == goal.value) {
      return std::nullopt;  // it began there
    }
    const bool is_below = *value < goal.value;
    if (nearest && nearest->is_greatest != is_below) {
      return std::nullopt;  // rows on both sides of it
    }
    if (!nearest || std::abs(*value - goal.value) < std::abs(nearest->value - goal.value)) {
      nearest = {.is_greatest = is_below, .value = *value, .time = row.time};
    }
  }
  return nearest;
}

void warn_of_missed_goals(const FoundSimulation& simulation,
                          const FileUnits& units,
                          Diagnostics& found) {
  const auto with_unit = [&](QuantityKind kind, double si) {
    return fmt::format("{} {}", format_short(units.from_si(kind, si)), units.text(kind));
  };
  for (const SimulationGoal& goal : simulation.plan.goals) {
    const bool turns = simulation.mechanism.topology.freedoms[at(goal.of.freedom)].is_rotation;
    const QuantityKind kind = goal.is_speed ? rate_kind(turns) : position_kind(turns);
    const std::optional<NearestRow> nearest = nearest_row(goal, simulation.solution);
    found.warning(
        "W0513",
        goal.of.where,
        fmt::format("'{}' did not reach {} in {}{}",
                    goal.of.name,
                    with_unit(kind, goal.value),
                    with_unit(QuantityKind::time, simulation.plan.duration),
                    nearest ? fmt::format(": {} of the rows {} at {}",
                                          nearest->is_greatest ? "greatest" : "least",
                                          with_unit(kind, nearest->value),
                                          with_unit(QuantityKind::time, nearest->time))
                            : ""),
        "raise 'time' if it is still on its way; else change the value, or what drives it");
  }
}

}  // namespace

std::optional<FoundSimulation> find_simulation(const MechanismDescription& description,
                                               Diagnostics& found) {
  if (!description.simulation) {
    found.error(
        "E0303",
        {},
        "the file has no section 'simulation'",
        "add simulation: {action: {ACTUATOR: …}, start: {ACTUATOR: {position: …}}, time: 5 s}");
    return std::nullopt;
  }
  if (!bind_unassembled(description, found)) {
    return std::nullopt;
  }
  const MechanismDescription simulated = simulated_description(description);
  Diagnostics again;  // Of what is bound a second time, warnings are there already.
  std::optional<Mechanism> mechanism = bind_unassembled(simulated, again);
  if (!mechanism) {
    for (const Diagnostic& one : again.items()) {
      if (one.severity == Severity::error) {
        found.error(one.code, one.where, one.message, one.hint);
      }
    }
    return std::nullopt;
  }
  std::optional<SimulationPlan> plan = read_simulation(description, *mechanism, found);
  if (!plan) {
    return std::nullopt;
  }
  std::vector<DrawnCoupling> drawn = bind_drawn_couplings(simulated, *mechanism);
  std::optional<Beginning> begin = StartFinder(*mechanism, *plan, found).find(drawn);
  if (!begin) {
    return std::nullopt;
  }
  FoundSimulation result{.mechanism = *std::move(mechanism),
                         .plan = *std::move(plan),
                         .network = std::move(begin->network),
                         .drawn = std::move(drawn),
                         .solution = {}};
  result.solution = solve_simulation(result.mechanism,
                                     result.network,
                                     result.drawn,
                                     result.plan,
                                     begin->configuration,
                                     begin->coordinates,
                                     begin->rates);
  if (result.solution.end == SimulationEnd::complete) {
    warn_of_missed_goals(result, description.units, found);
  }
  if (result.solution.end == SimulationEnd::stuck) {
    const double time = result.solution.rows.empty() ? 0.0 : result.solution.rows.back().time;
    const FileUnits& units = description.units;
    const SimulationObstacle::Kind why = result.solution.obstacle.kind;
    const bool is_painleve = why == SimulationObstacle::Kind::friction_without_end ||
                             why == SimulationObstacle::Kind::friction_in_two_ways;
    found.error(is_painleve ? "E0519" : "E0515",
                result.plan.where,
                fmt::format("the simulation cannot go on after {} {}: {}",
                            format_short(units.from_si(QuantityKind::time, time)),
                            units.text(QuantityKind::time),
                            name_of(result.solution.obstacle, result.mechanism)),
                std::string(hint_of(result.solution.obstacle)));
  }
  return result;
}

}  // namespace kinestat
