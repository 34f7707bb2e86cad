#include "studies/tolerance/influences.hpp"

#include <algorithm>
#include <cmath>

#include "core/index.hpp"
#include "core/rounding.hpp"
#include "math/dense/least_norm.hpp"
#include "math/elimination/data_zero.hpp"
#include "mechanism/position_error.hpp"
#include "network/node_system.hpp"
#include "studies/tolerance/central_deviation.hpp"

namespace kinestat {

namespace {

// The coupling's screws with its point as the origin, so that lengths are as small as the joint.
Twist seen_from(const Twist& twist, const Vec3& at) {
  return {.angular = twist.angular, .linear = velocity_at<double>(twist, at)};
}

// The wrench of tail on head that does work on one freedom of a coupling, and on no other, nor on
// deviations of its parts: what holds the freedom, or pushes along it.
Wrench freedom_wrench(const Mechanism& mechanism,
                      int freedom,
                      std::span<const Deviation> deviations) {
  const Topology& topology = mechanism.topology;
  const CouplingId id = topology.freedoms[at(freedom)].coupling;
  const CouplingTopology& coupling = topology.coupling(id);
  const Vec3& point = mechanism.geometry.points[at(id.value)];
  std::vector<Twist> twists;
  for (int f = coupling.first_freedom; f < coupling.first_freedom + coupling.freedom_count; ++f) {
    twists.push_back(seen_from(mechanism.geometry.motions[at(f)], point));
  }
  for (const Deviation& one : deviations) {
    if (topology.actions[at(one.action)].coupling == id) {
      twists.push_back(seen_from(one.unit, point));
    }
  }
  MatX rows(std::ssize(twists), 6);
  for (std::size_t i = 0; i < twists.size(); ++i) {
    rows.row(static_cast<Eigen::Index>(i)) = twists[i].coordinates();
  }
  const VecX work = VecX::Unit(std::ssize(twists), freedom - coupling.first_freedom);
  const Vec6 seen = least_norm_solution(rows, work);
  const Wrench wrench = Wrench::from_coordinates(seen);
  return {.moment = wrench.moment + moment_of_line<double>(point, wrench.force),
          .force = wrench.force};
}

// The mechanism with the actions that hold deviations, and those that hold the drives.
class HeldMechanism {
 public:
  HeldMechanism(const Mechanism& mechanism,
                const Case& which,
                std::span<const Deviation> deviations)
      : mechanism_(mechanism),
        deviations_(deviations),
        topology_(mechanism.topology),
        geometry_(mechanism.geometry),
        basis_(mechanism.space == Space::planar
                   ? planar_basis(ScrewKind::wrench, mechanism.geometry.length)
                   : spatial_basis(ScrewKind::wrench, mechanism.geometry.length)) {
    topology_.actions.clear();
    geometry_.actions.clear();
    drives_.resize(which.motions.size());
    parts_.resize(deviations.size());
    for (int e = 0; e < topology_.coupling_count(); ++e) {
      add_actions(CouplingId{e}, which);
    }
    elimination_.emplace(action_system(topology_, geometry_, basis_), std::span<const int>());
    inexact_ = {.rows = basis_.order(),
                .first_column = 0,
                .share = std::max(position_error(mechanism), kDataRounding)};
  }

  // Whether equilibrium alone tells the action that holds each of the deviations.
  std::vector<bool> determined() const {
    std::vector<bool> result(deviations_.size(), true);
    for (const VecX& stress : settled_null_vectors(*elimination_, inexact_)) {
      for (std::size_t d = 0; d < result.size(); ++d) {
        result[d] = result[d] && stress[parts_[d]] == 0.0;
      }
    }
    return result;
  }

  std::optional<Influence> influence_on(const WatchedPosition& position,
                                        const std::vector<bool>& fits) const {
    const std::vector<BodyWrench> loads = unit_loads(position);
    const std::vector<double> right = load_vector(topology_.body_count(), basis_, loads);
    EliminationSolution solved = elimination_->solve({}, right);
    if (!solved.consistent) {
      return std::nullopt;
    }
    settle_inexact(*elimination_, right, inexact_, solved.x);
    Influence result;
    for (const int part : parts_) {
      result.by_parts.push_back(way(part, solved.x));
    }
    cancel_planets(mechanism_, loads, deviations_, fits, result.by_parts);
    for (const int drive : drives_) {
      result.by_drives.push_back(way(drive, solved.x));
    }
    return result;
  }

 private:
  // Those of one coupling follow each other.
  void add_actions(CouplingId id, const Case& which) {
    CouplingTopology& coupling = topology_.couplings[at(id.value)];
    coupling.first_action = topology_.action_count();
    for (std::size_t d = 0; d < deviations_.size(); ++d) {
      const std::size_t a = at(deviations_[d].action);
      if (mechanism_.topology.actions[a].coupling == id) {
        parts_[d] = topology_.action_count();
        topology_.actions.push_back(mechanism_.topology.actions[a]);
        geometry_.actions.push_back(mechanism_.geometry.actions[a]);
      }
    }
    for (std::size_t h = 0; h < which.motions.size(); ++h) {
      const int freedom = which.motions[h].index;
      const FreedomLabel& label = topology_.freedoms[at(freedom)];
      if (label.coupling == id) {
        drives_[h] = topology_.action_count();
        topology_.actions.push_back(
            {.coupling = id, .name = label.name, .is_couple = label.is_rotation});
        geometry_.actions.push_back(freedom_wrench(mechanism_, freedom, deviations_));
      }
    }
    coupling.action_count = topology_.action_count() - coupling.first_action;
  }

  // The way that the position goes by a unit of what that action holds.
  double way(int action, const VecX& x) const {
    const double magnitude = x[action] * action_unit(topology_, basis_, action);
    return magnitude == 0.0 ? 0.0 : -magnitude;
  }

  // What does unit work on the position.
  std::vector<BodyWrench> unit_loads(const WatchedPosition& position) const {
    if (const auto* body = std::get_if<BodyDisplacement>(&position.of)) {
      const Wrench unit =
          body->at ? unit_force(body->direction, *body->at) : unit_couple(body->direction);
      return {{.body = body->body, .wrench = unit}};
    }
    const int freedom = std::get<int>(position.of);
    const Wrench unit = freedom_wrench(mechanism_, freedom, deviations_);
    const CouplingTopology& coupling = topology_.coupling(topology_.freedoms[at(freedom)].coupling);
    return {{.body = coupling.head, .wrench = unit},
            {.body = coupling.tail, .wrench = -1.0 * unit}};
  }

  const Mechanism& mechanism_;
  std::span<const Deviation> deviations_;
  Topology topology_;
  Geometry geometry_;
  CoordinateBasis basis_;
  std::vector<int> parts_;   ///< of each deviation: the action that holds it
  std::vector<int> drives_;  ///< likewise of each known motion
  std::optional<Elimination> elimination_;
  InexactBlocks inexact_;
};

}  // namespace

Influences find_influences(const Mechanism& mechanism,
                           const Case& which,
                           std::span<const Deviation> deviations,
                           std::span<const WatchedPosition> watched) {
  const HeldMechanism held(mechanism, which, deviations);
  Influences result{.of = {}, .fits = held.determined()};
  for (const WatchedPosition& position : watched) {
    result.of.push_back(held.influence_on(position, result.fits));
  }
  return result;
}

}  // namespace kinestat
