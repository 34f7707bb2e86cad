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
#include "studies/motion/configuration.hpp"
#include "studies/motion/motion.hpp"
#include "studies/simulation/simulation_network.hpp"
#include "studies/simulation/task/read_simulation.hpp"
#include "studies/simulation/task/simulation_findings.hpp"
#include "studies/simulation/task/simulation_limits.hpp"

namespace kinestat {

namespace {

class StartFinder {
 public:
  StartFinder(const Mechanism& mechanism, const SimulationPlan& plan, Diagnostics& found)
      : mechanism_(mechanism), topology_(mechanism.topology), plan_(plan), found_(found) {}

  // Of the freedoms that stick by themselves, those of `preferred` are joints of the tree before
  // others: not all in a circuit can be. Where it begins does not depend on them.
  std::optional<SimulationBegin> find(const std::vector<DrawnCoupling>& drawn,
                                      const std::vector<int>& preferred) {
    const std::vector<int> sticking = sticking_freedoms(mechanism_);
    std::vector<int> more = topology_.driven_freedoms();
    more.insert(more.end(), sticking.begin(), sticking.end());
    more = ground_first(std::move(more));
    const MotionNetwork network =
        make_simulation_network(mechanism_, drawn, plan_, named(true), more);
    if (!check_movable(network) || !check_goals(network)) {
      return std::nullopt;
    }
    std::optional<std::vector<int>> driven = choose(network);
    if (!driven) {
      return std::nullopt;
    }
    SimulationBegin begin{.network = with_drives(network, *driven)};
    begin.coordinates = *driven;
    if (!go_to_start(begin)) {
      return std::nullopt;
    }
    const bool has_all = std::ranges::all_of(
        sticking, [&](int freedom) { return rate_of_freedom(network, freedom) >= 0; });
    if (!has_all) {
      std::vector<int> first = sticking;
      std::stable_partition(first.begin(), first.end(), [&](int freedom) {
        return std::ranges::find(preferred, freedom) != preferred.end();
      });
      const std::vector<int> starts = named(true);
      first.insert(first.end(), starts.begin(), starts.end());
      const MotionNetwork other =
          make_simulation_network(mechanism_, drawn, plan_, named(false), first);
      return begin_in_other_tree(mechanism_, begin, other, rates_of(other)).value_or(begin);
    }
    return begin;
  }

 private:
  // Those of couplings on the ground before others: where a start does not name enough freedoms,
  // these begin at rest, rather than what moves with others.
  std::vector<int> ground_first(std::vector<int> freedoms) const {
    std::stable_partition(freedoms.begin(), freedoms.end(), [&](int freedom) {
      const CouplingTopology& coupling =
          topology_.coupling(topology_.freedoms[at(freedom)].coupling);
      return coupling.tail.value == 0 || coupling.head.value == 0;
    });
    return freedoms;
  }

  // Freedoms that must be joints of the tree: those that are held or stopped, and those given.
  std::vector<int> named(bool with_starts) const {
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
      if (with_starts) {
        add(one.of);
      }
    }
    for (const SimulationStop& one : plan_.stops) {
      add(one.of);
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
    for (const int freedom : ground_first(topology_.driven_freedoms())) {
      const int rate = rate_of_freedom(network, freedom);
      if (rate >= 0 && std::ranges::find(preferred, rate) == preferred.end()) {
        preferred.push_back(rate);
      }
    }
    std::vector<int> chosen = independent_rates(network, motions, preferred);
    if (static_cast<Eigen::Index>(chosen.size()) < motions.cols()) {
      refuse_unnamed(network);
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

  // Motions that no freedom with a position tells apart.
  void refuse_unnamed(const MotionNetwork& network) {
    for (int b = 1; b < topology_.body_count(); ++b) {
      const int frame = network.frame_of_body[at(b)];
      const MotionJoint& last = network.joints[at(frame - 1)];
      if (frame > 0 && last.coordinate >= 0 && last.freedom < 0) {
        return refuse(SimulationLimit::unguided_body,
                      topology_.body({b}).where,
                      fmt::format("body '{}'", topology_.body({b}).name),
                      found_);
      }
    }
    for (const BallFreedoms& ball : network.balls) {
      const CouplingId id = topology_.freedoms[at(ball.first_freedom)].coupling;
      return refuse(SimulationLimit::ball,
                    topology_.coupling(id).where,
                    fmt::format("'{}'", topology_.coupling(id).name),
                    found_);
    }
    refuse(SimulationLimit::ball, plan_.where, "some turn in the drawn position", found_);
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

  bool go_to_start(SimulationBegin& begin) {
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
                   : way.status == MotionStatus::lost_branch || way.status == MotionStatus::limit ||
                           way.status == MotionStatus::lift_off
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
    std::optional<BodyId> body = spinning_body(begin, speeds.size());
    body = body ? body : pushed_idle_body(mechanism_, plan_, begin.network);
    if (body) {
      refuse(SimulationLimit::idle_inertia,
             topology_.body(*body).where,
             fmt::format("body '{}'", topology_.body(*body).name),
             found_);
      return false;
    }
    begin.rates =
        *units * Eigen::Map<const VecX>(speeds.data(), static_cast<Eigen::Index>(speeds.size()));
    return true;
  }

  // Of the named freedoms, then of the actuators, as far as the tree has them.
  std::vector<int> rates_of(const MotionNetwork& network) const {
    std::vector<int> freedoms = named(true);
    const std::vector<int> driven = ground_first(topology_.driven_freedoms());
    freedoms.insert(freedoms.end(), driven.begin(), driven.end());
    std::vector<int> rates;
    for (const int freedom : freedoms) {
      const int rate = rate_of_freedom(network, freedom);
      if (rate >= 0 && std::ranges::find(rates, rate) == rates.end()) {
        rates.push_back(rate);
      }
    }
    return rates;
  }

  // Whose inertia a motion would speed up that no other body feels.
  std::optional<BodyId> spinning_body(const SimulationBegin& begin, std::size_t drives) const {
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

// The freedom that would stick and is no joint of the tree.
std::optional<int> stuck_in_circuit(const FoundSimulation& of) {
  const SimulationObstacle& obstacle = of.solution.obstacle;
  return of.solution.end == SimulationEnd::stuck &&
                 obstacle.kind == SimulationObstacle::Kind::stuck_in_circuit
             ? std::optional(of.mechanism.topology.coupling(*obstacle.coupling).first_freedom)
             : std::nullopt;
}

// Anew with another tree where something sticks that is no joint of the one before; which one goes
// farthest. False where there is no start.
bool simulate(FoundSimulation& result, Diagnostics& found) {
  std::vector<int> preferred;
  for (;;) {
    std::optional<SimulationBegin> begin =
        StartFinder(result.mechanism, result.plan, found).find(result.drawn, preferred);
    if (!begin) {
      return false;
    }
    SimulationSolution solution = solve_simulation(result.mechanism,
                                                   begin->network,
                                                   result.drawn,
                                                   result.plan,
                                                   begin->configuration,
                                                   begin->coordinates,
                                                   begin->rates);
    if (preferred.empty() || solution.end != SimulationEnd::stuck ||
        solution.time > result.solution.time) {
      result.network = std::move(begin->network);
      result.solution = std::move(solution);
    }
    const std::optional<int> freedom = stuck_in_circuit(result);
    if (!freedom || std::ranges::find(preferred, *freedom) != preferred.end()) {
      return true;
    }
    preferred.insert(preferred.begin(), *freedom);
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
  FoundSimulation result{.mechanism = *std::move(mechanism),
                         .plan = *std::move(plan),
                         .network = {},
                         .drawn = std::move(drawn),
                         .solution = {}};
  if (!simulate(result, found)) {
    return std::nullopt;
  }
  add_simulation_findings(result, description, found);
  return result;
}

}  // namespace kinestat
