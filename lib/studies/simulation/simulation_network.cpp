#include "studies/simulation/simulation_network.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/index.hpp"
#include "core/simulation_tolerance.hpp"
#include "core/tolerance.hpp"
#include "dynamics/body_inertia.hpp"
#include "studies/mobility/passive_freedom.hpp"
#include "studies/motion/configuration.hpp"
#include "studies/motion/joint_follower.hpp"
#include "studies/motion/motion.hpp"
#include "studies/motion/motion_state.hpp"
#include "studies/simulation/rubbing.hpp"

namespace kinestat {

namespace {

// In so many steps a start is carried over to another tree.
constexpr int kStepsToStart = 64;

// Whether anything acts on a motion that no other body feels.
class IdleMotion {
 public:
  IdleMotion(const Mechanism& mechanism, const SimulationPlan& plan, const PassiveFreedom& idle)
      : mechanism_(mechanism), plan_(plan), idle_(idle) {}

  bool counts() const { return has_inertia() || is_pushed(); }

  bool is_pushed() const { return has_spring() || has_load() || has_friction() || is_named(); }

 private:
  const Twist* twist_of(BodyId body) const {
    const auto found = std::ranges::find(idle_.bodies, body);
    return found == idle_.bodies.end()
               ? nullptr
               : &idle_.twists[static_cast<std::size_t>(found - idle_.bodies.begin())];
  }

  double length() const { return mechanism_.geometry.length; }

  bool has_inertia() const {
    return std::ranges::any_of(idle_.bodies, [&](BodyId id) {
      const BodyMass& mass = mechanism_.masses[at(id.value)];
      if (!mass.counts()) {
        return false;
      }
      const Twist& twist = *twist_of(id);
      const BodyInertia body = inertia_at(mass, BodyPose{});
      const double fastest =
          twist.angular.squaredNorm() + twist.linear.squaredNorm() / (length() * length());
      const double most = (body.tensor.norm() + body.mass * length() * length()) * fastest;
      return shared_inertia(body, twist, twist) > kIdleInertia * most;
    });
  }

  bool shifts(BodyId body, const Vec3& point) const {
    const Twist* const twist = twist_of(body);
    return twist != nullptr &&
           velocity_at(*twist, point).norm() >
               kRankZero * (twist->angular.norm() * length() + twist->linear.norm());
  }

  bool turns(BodyId body) const {
    const Twist* const twist = twist_of(body);
    return twist != nullptr && twist->angular.norm() > 0.0;
  }

  bool has_spring() const {
    return std::ranges::any_of(mechanism_.springs, [&](const Spring& one) {
      return one.is_of_freedom() ? idle_.moves(one.freedom)
                                 : shifts(one.tail, one.from) || shifts(one.head, one.to);
    });
  }

  bool has_load() const {
    const Case& which = mechanism_.cases.front();
    return turns_load(idle_, which) ||
           std::ranges::any_of(
               which.loads,
               [&](const Load& one) {
                 return one.point ? shifts(one.acts.body, *one.point) ||
                                        (turns(one.acts.body) && couple_of(one).norm() > 0.0)
                                  : turns(one.acts.body) && one.acts.wrench.moment.norm() > 0.0;
               }) ||
           std::ranges::any_of(which.moving_loads, [&](const MovingLoad& one) {
             return turns(one.body) || (one.point && shifts(one.body, *one.point));
           });
  }

  bool has_friction() const {
    return std::ranges::any_of(find_rubbing(mechanism_), [&](const Rubbing& one) {
      return std::ranges::any_of(
          one.slides, [&](const SlidingTerm& term) { return idle_.moves(term.freedom); });
    });
  }

  bool is_named() const {
    const auto names = [&](const auto& list) {
      return std::ranges::any_of(list,
                                 [&](const auto& one) { return idle_.moves(one.of.freedom); });
    };
    return names(plan_.starts) || names(plan_.stops) || names(plan_.goals) ||
           std::ranges::any_of(mechanism_.curves, [&](const Curve& one) {
             return one.freedom >= 0 && idle_.moves(one.freedom);
           });
  }

  const Mechanism& mechanism_;
  const SimulationPlan& plan_;
  const PassiveFreedom& idle_;
};

bool has_joint(const MotionNetwork& network, const PassiveFreedom& idle) {
  for (int f = 0; f < static_cast<int>(idle.rates.size()); ++f) {
    if (idle.moves(f) && rate_of_freedom(network, f) >= 0) {
      return true;
    }
  }
  return false;
}

void keep_idle(const Mechanism& mechanism, const SimulationPlan& plan, MotionNetwork& network) {
  if (network.passive_motions.empty()) {
    return;
  }
  const std::vector<PassiveFreedom> all =
      find_passive_freedoms(mechanism, spatial_basis(ScrewKind::twist, network.length));
  std::vector<VecX> motions;
  std::vector<int> freedoms;
  for (std::size_t p = 0; p < all.size(); ++p) {
    if (!has_joint(network, all[p]) || !IdleMotion(mechanism, plan, all[p]).counts()) {
      motions.push_back(std::move(network.passive_motions[p]));
      freedoms.push_back(network.passive_freedoms[p]);
    }
  }
  network.passive_motions = std::move(motions);
  network.passive_freedoms = std::move(freedoms);
}

// The configuration of a network in which the freedoms are where they are in the last position of a
// motion of another.
std::optional<Configuration> carried_over(const Mechanism& mechanism,
                                          const MotionNetwork& from,
                                          const MotionSolution& way,
                                          const MotionNetwork& to) {
  Configuration there = drawn_configuration(to);
  std::vector<std::optional<double>> positions;
  for (int i = 0; i < way.position_count(); ++i) {
    positions = freedom_positions(from, mechanism, way.configuration_at(i));
    const MotionNetwork driven =
        with_drives(to, independent_rates(to, JointFollower(to).free_motions(there), {}));
    std::vector<double> drives;
    for (const int freedom : driven.driven_freedoms) {
      if (!positions[at(freedom)]) {
        return std::nullopt;
      }
      drives.push_back(*positions[at(freedom)]);
    }
    if (!JointFollower(driven).follow(there, drives)) {
      return std::nullopt;
    }
  }
  const auto found = freedom_positions(to, mechanism, there);
  for (std::size_t f = 0; f < found.size(); ++f) {
    const double unit = mechanism.topology.freedoms[f].is_rotation ? 1.0 : from.length;
    if (found[f] && positions[f] && std::abs(*found[f] - *positions[f]) > kSamePosition * unit) {
      return std::nullopt;
    }
  }
  return there;
}

}  // namespace

std::optional<BodyId> pushed_idle_body(const Mechanism& mechanism,
                                       const SimulationPlan& plan,
                                       const MotionNetwork& network) {
  if (network.passive_motions.empty()) {
    return std::nullopt;
  }
  for (const PassiveFreedom& one :
       find_passive_freedoms(mechanism, spatial_basis(ScrewKind::twist, network.length))) {
    if (!has_joint(network, one) && IdleMotion(mechanism, plan, one).is_pushed()) {
      return one.bodies.front();
    }
  }
  return std::nullopt;
}

std::vector<int> sticking_freedoms(const Mechanism& mechanism) {
  std::vector<int> all;
  for (const Rubbing& one : find_rubbing(mechanism)) {
    if (one.slides.size() == 1 && one.is_dry()) {
      all.push_back(one.slides.front().freedom);
    }
  }
  return all;
}

MotionNetwork make_simulation_network(const Mechanism& mechanism,
                                      std::span<const DrawnCoupling> drawn,
                                      const SimulationPlan& plan,
                                      std::vector<int> first,
                                      std::span<const int> more) {
  MotionNetwork network = make_motion_network(mechanism, drawn, first);
  for (const int freedom : more) {
    if (!network.is_movable() || std::ranges::find(first, freedom) != first.end()) {
      continue;
    }
    first.push_back(freedom);
    MotionNetwork with = make_motion_network(mechanism, drawn, first);
    if (with.is_movable()) {
      network = std::move(with);
    } else {
      first.pop_back();
    }
  }
  keep_idle(mechanism, plan, network);
  return network;
}

std::optional<SimulationBegin> begin_in_other_tree(const Mechanism& mechanism,
                                                   const SimulationBegin& begin,
                                                   const MotionNetwork& other,
                                                   std::span<const int> preferred) {
  const auto unit = [&](int freedom) {
    return mechanism.topology.freedoms[at(freedom)].is_rotation ? 1.0 : begin.network.length;
  };
  const auto positions = freedom_positions(begin.network, mechanism, begin.configuration);
  MotionTask task{.drives = {}, .steps = kStepsToStart};
  GivenSpeeds given;
  for (std::size_t d = 0; d < begin.network.driven_freedoms.size(); ++d) {
    const int freedom = begin.network.driven_freedoms[d];
    task.drives.push_back(
        {.freedom = freedom, .from = 0.0, .to = positions[at(freedom)].value_or(0.0)});
    given.drives.push_back({.speed = begin.rates[begin.network.driven_rates[d]] * unit(freedom)});
  }
  const MotionSolution way = solve_motion(begin.network, task);
  if (!other.is_movable() || way.status != MotionStatus::completed) {
    return std::nullopt;
  }
  const auto there = carried_over(mechanism, begin.network, way, other);
  if (!there) {
    return std::nullopt;
  }
  SimulationBegin result{.network = other, .configuration = *there};
  result.coordinates =
      independent_rates(other, JointFollower(other).free_motions(*there), preferred);
  result.network = with_drives(other, result.coordinates);
  const std::vector<std::optional<double>> rates =
      MotionStates(begin.network, mechanism)
          .solve(begin.configuration, given, StateDetail::velocity)
          .rates;
  VecX speeds(static_cast<Eigen::Index>(result.coordinates.size()));
  for (std::size_t d = 0; d < result.coordinates.size(); ++d) {
    const int freedom = result.network.driven_freedoms[d];
    if (at(freedom) >= rates.size() || !rates[at(freedom)]) {
      return std::nullopt;
    }
    speeds[static_cast<Eigen::Index>(d)] = *rates[at(freedom)] / unit(freedom);
  }
  const std::optional<MatX> units = JointFollower(result.network).unit_rates(*there);
  if (!units) {
    return std::nullopt;
  }
  result.rates = *units * speeds;
  return result;
}

}  // namespace kinestat
