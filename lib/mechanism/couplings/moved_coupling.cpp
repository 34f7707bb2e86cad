#include "mechanism/couplings/moved_coupling.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "couplings/coupling_catalogue.hpp"
#include "couplings/finite_law.hpp"
#include "couplings/kinds.hpp"
#include "couplings/mechanics.hpp"

namespace kinestat {

namespace {

// The least one that brings a unit vector to another; in the plane about z.
Mat3 least_turn(const Vec3& from, const Vec3& to) {
  if (from.z() == 0.0 && to.z() == 0.0) {
    const double angle = std::atan2(from.cross(to).z(), from.dot(to));
    return Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
  }
  return Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix();
}

// That which brings two directions across each other to two others.
Mat3 turn_of_frame(const std::pair<Vec3, Vec3>& from, const std::pair<Vec3, Vec3>& to) {
  const auto frame = [](const std::pair<Vec3, Vec3>& axes) {
    Mat3 result;
    result << axes.first, axes.second, axes.first.cross(axes.second);
    return result;
  };
  return frame(to) * frame(from).transpose();
}

class Mover {
 public:
  Mover(const Mechanism& mechanism,
        CouplingId id,
        const DrawnCoupling& drawn,
        const CouplingPoses& poses)
      : mechanism_(mechanism),
        coupling_(mechanism.topology.coupling(id)),
        drawn_(drawn),
        poses_(poses) {}

  MovedCoupling move() {
    if (carried_.place == Follows::contact) {
      touch();
    }
    place();
    if (carried_.are_found_anew) {
      stretch();
    } else {
      carry();
    }
    add_actuators();
    return std::move(result_);
  }

 private:
  const BodyPose& pose_of(Follows who) const {
    static const BodyPose kStill;
    switch (who) {
      case Follows::tail:
        return poses_.tail;
      case Follows::head:
        return poses_.head;
      case Follows::carrier:
        return poses_.carrier;
      case Follows::contact:
        return contact_;
      case Follows::world:
        break;
    }
    return kStill;
  }

  int passive_count() const {
    int count = 0;
    for (int a = 0; a < coupling_.action_count; ++a) {
      const auto i = static_cast<std::size_t>(coupling_.first_action + a);
      count += mechanism_.topology.actions[i].actuator < 0 ? 1 : 0;
    }
    return count;
  }

  // What slides takes its point along; teeth touch in their carrier.
  void place() {
    const Follows who = carried_.place;
    const Vec3 at =
        who == Follows::head ? drawn_.at_head.value_or(drawn_.geometry.at) : drawn_.geometry.at;
    result_.point = pose_of(who).point(at);
  }

  // Both parts of a screw, the one along its line first.
  std::pair<Vec3, Vec3> carried(const Vec3& line, const Vec3& moment, Carried rule) const {
    const Vec3& arm = drawn_.geometry.at;
    const BodyPose& turns = pose_of(rule.direction);
    const Vec3 at = rule.point == Follows::head ? drawn_.at_head.value_or(drawn_.geometry.at)
                                                : drawn_.geometry.at;
    const Vec3 moved_arm = pose_of(rule.point).point(at);
    const Vec3 moved_line = turns.direction(line);
    const Vec3 own = turns.direction(moment - arm.cross(line));
    return {moved_line, own + moment_of_line<double>(moved_arm, moved_line)};
  }

  void carry() {
    for (int f = 0; f < coupling_.freedom_count; ++f) {
      const Twist& screw =
          mechanism_.geometry.motions[static_cast<std::size_t>(coupling_.first_freedom + f)];
      const auto [line, moment] =
          carried(screw.angular, screw.linear, carried_.freedom(f, !screw.angular.isZero(0.0)));
      result_.motions.push_back({.angular = line, .linear = moment});
    }
    for (int a = 0; a < passive_count(); ++a) {
      const auto i = static_cast<std::size_t>(coupling_.first_action + a);
      const Wrench& screw = mechanism_.geometry.actions[i];
      const bool is_couple = mechanism_.topology.actions[i].is_couple;
      if (is_couple && carried_.couple_is_across_turns) {
        result_.actions.push_back(couple_across_turns(screw));
        continue;
      }
      const auto [line, moment] =
          carried(screw.force, screw.moment, is_couple ? carried_.couples : carried_.forces);
      result_.actions.push_back({.moment = moment, .force = line});
    }
  }

  // On the side on which it was drawn.
  Wrench couple_across_turns(const Wrench& drawn) const {
    const auto first = static_cast<std::size_t>(coupling_.first_freedom);
    const Vec3& one = mechanism_.geometry.motions[first].angular;
    const Vec3& other = mechanism_.geometry.motions[first + 1].angular;
    const double side = one.cross(other).dot(drawn.moment) < 0.0 ? -1.0 : 1.0;
    const Vec3 across = result_.motions[0].angular.cross(result_.motions[1].angular).normalized();
    return unit_couple<double>(side * across);
  }

  // Cables by the catalogue, from where they end now.
  void stretch() {
    CouplingGeometry moved = drawn_.geometry;
    if (drawn_.from && drawn_.to) {
      const CableSpan span = tangent_span<double>(moved_station(*drawn_.from, poses_.tail),
                                                  moved_station(*drawn_.to, poses_.head));
      moved.from = span.from;
      moved.to = span.to;
    } else {
      moved.from = poses_.tail.point(drawn_.geometry.from);
      moved.to = poses_.head.point(drawn_.geometry.to);
    }
    result_.point = moved.to;
    const CouplingScrews screws = coupling_screws(coupling_.type, mechanism_.space, moved);
    for (const NamedTwist& freedom : screws.freedoms) {
      result_.motions.push_back(freedom.screw);
    }
    for (const NamedWrench& constraint : screws.constraints) {
      if (static_cast<int>(result_.actions.size()) < passive_count()) {
        result_.actions.push_back(constraint.screw);
      }
    }
  }

  // Where the bodies touch now. The normal joins the centres, or stands on the flat side, with
  // which directions across it turn; between round sides these turn no more than it does.
  void touch() {
    const double tail = drawn_.tail_shape ? drawn_.tail_shape->curvature : 0.0;
    const double head = drawn_.head_shape ? drawn_.head_shape->curvature : 0.0;
    const Vec3& normal = drawn_.geometry.axis.direction;
    const Vec3& at = drawn_.geometry.at;
    Vec3 now = at;
    if (tail == 0.0) {
      contact_.rotation = poses_.tail.rotation;
      now = head == 0.0
                ? poses_.tail.point(at)
                : poses_.head.point(at + normal / head) - poses_.tail.direction(normal) / head;
    } else if (head == 0.0) {
      contact_.rotation = poses_.head.rotation;
      now = poses_.tail.point(at - normal / tail) + poses_.head.direction(normal) / tail;
    } else {
      const Vec3 a = poses_.tail.point(at - normal / tail);
      const Vec3 b = poses_.head.point(at + normal / head);
      const double side = 1.0 / tail + 1.0 / head < 0.0 ? -1.0 : 1.0;
      const Vec3 moved_normal = side * (b - a).normalized();
      contact_.rotation = least_turn(normal, moved_normal);
      now = a + moved_normal / tail;
    }
    if (touches_along_line()) {
      const Vec3& line = drawn_.geometry.second.direction;
      contact_.rotation = turn_of_frame(
          {normal, line},
          {contact_.rotation * normal, (tail == 0.0 ? poses_.head : poses_.tail).direction(line)});
    }
    contact_.shift = now - contact_.rotation * at;
  }

  bool touches_along_line() const {
    return std::ranges::any_of(kind_of(coupling_.type).keys,
                               [](const KindKey& one) { return one.key == CouplingKey::line; });
  }

  void add_actuators() {
    for (int a = passive_count(); a < coupling_.action_count; ++a) {
      const auto i = static_cast<std::size_t>(coupling_.first_action + a);
      const int actuator = mechanism_.topology.actions[i].actuator;
      const int freedom = mechanism_.topology.actuators[static_cast<std::size_t>(actuator)].freedom;
      const NamedTwist driven = {
          .name = {},
          .is_rotation =
              mechanism_.topology.freedoms[static_cast<std::size_t>(freedom)].is_rotation,
          .screw = result_.motions[static_cast<std::size_t>(freedom - coupling_.first_freedom)]};
      result_.actions.push_back(internal_action<double>(driven, result_.point).screw);
    }
  }

  const Mechanism& mechanism_;
  const CouplingTopology& coupling_;
  const CarriedParts& carried_ = kind_of(coupling_.type).mechanics->carried;
  const DrawnCoupling& drawn_;
  const CouplingPoses& poses_;
  BodyPose contact_;  // of what turns with the normal
  MovedCoupling result_;
};

}  // namespace

MovedCoupling moved_coupling(const Mechanism& mechanism,
                             CouplingId coupling,
                             const DrawnCoupling& drawn,
                             const CouplingPoses& poses) {
  return Mover(mechanism, coupling, drawn, poses).move();
}

CableStationGeometry moved_station(CableStationGeometry station, const BodyPose& pose) {
  station.centre = pose.point(station.centre);
  station.axis = pose.direction(station.axis);
  for (auto* point : {&station.meets, &station.leaves}) {
    if (*point) {
      *point = pose.point(**point);
    }
  }
  return station;
}

}  // namespace kinestat
