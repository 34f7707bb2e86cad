#include "statics/friction_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/contract.hpp"
#include "core/tolerance.hpp"

namespace kinestat {

namespace {

using Part = Eigen::Matrix<double, 3, 6>;

Eigen::Matrix3d cross_matrix(const Vec3& v) {
  Eigen::Matrix3d result;
  result << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return result;
}

// Takes the component across a unit vector.
Eigen::Matrix3d across(const Vec3& axis) {
  return Eigen::Matrix3d::Identity() - axis * axis.transpose();
}

PressingPart force_part(const Eigen::Matrix3d& of_force, double weight) {
  PressingPart result;
  result.part.rightCols<3>() = of_force;
  result.weight = weight;
  return result;
}

// What all laws of a coupling begin with.
struct Sliding {
  const Mechanism& mechanism;
  const CouplingFriction& friction;
  const CouplingTopology& coupling;
  Twist twist;  ///< head relative to tail
  Vec3 at;      ///< of the coupling, from the origin of the geometry

  const Twist& unit() const {
    return mechanism.geometry.motions[static_cast<std::size_t>(coupling.first_freedom)];
  }
};

FrictionLaw law_of(const Sliding& s, const Wrench& unit, double speed, bool is_couple) {
  FrictionLaw law;
  law.coupling = s.friction.coupling;
  law.unit = unit;
  law.speed = speed;
  law.is_couple = is_couple;
  return law;
}

// A couple about the axis, whose constant part is the same for journals and threads.
FrictionLaw turning(const Sliding& s) {
  const Vec3 axis = s.unit().angular;
  const double rate = s.twist.angular.dot(axis);
  const double against = rate > 0.0 ? -1.0 : 1.0;
  FrictionLaw law = law_of(s, unit_couple(against * axis), std::abs(rate), true);
  law.constant = s.friction.tau + s.friction.viscous * std::abs(rate);
  return law;
}

// It presses at its two ends: R/2 ± (M x a)/length, M the couple across the axis about the middle.
std::vector<PressingPart> edges(const Sliding& s, const Vec3& axis, double length, double weight) {
  std::vector<PressingPart> parts;
  for (const double side : {1.0, -1.0}) {
    PressingPart edge = force_part(0.5 * across(axis), weight);
    const Eigen::Matrix3d of_moment = (-side / length) * cross_matrix(axis) * across(axis);
    edge.part.leftCols<3>() = of_moment;
    edge.part.rightCols<3>() -= of_moment * cross_matrix(s.at);
    parts.push_back(edge);
  }
  return parts;
}

// The couple across the axis about the place of the coupling.
PressingPart tilting_part(const Sliding& s, const Vec3& axis) {
  PressingPart result;
  result.part.leftCols<3>() = across(axis);
  result.part.rightCols<3>() = -across(axis) * cross_matrix(s.at);
  return result;
}

// The couple about the axis.
PressingPart torsion_part(const Sliding& s, const Vec3& axis, double weight) {
  PressingPart result;
  result.part.row(0).leftCols<3>() = axis.transpose();
  result.part.row(0).rightCols<3>() = -axis.transpose() * cross_matrix(s.at);
  result.weight = weight;
  return result;
}

PressingPart axial_part(const Vec3& axis, double weight) {
  PressingPart result;
  result.part.row(0).rightCols<3>() = axis.transpose();
  result.weight = weight;
  return result;
}

// What presses across the axis, with the coefficient of its friction.
void add_across(const Sliding& s, const Vec3& axis, double weight, FrictionLaw& law) {
  if (s.friction.length) {
    law.parts = edges(s, axis, *s.friction.length, weight);
    return;
  }
  law.parts = {force_part(across(axis), weight)};
  if (weight > 0.0) {
    law.ignored.push_back({Reaction::tilting, tilting_part(s, axis).part});
  }
}

// The tension of a segment.
PressingPart tension_part(const Mechanism& mechanism, CouplingId segment, double weight) {
  const auto a = static_cast<std::size_t>(mechanism.topology.coupling(segment).first_action);
  PressingPart result = axial_part(mechanism.geometry.actions[a].force, weight);
  result.of = segment;
  return result;
}

// Ropes hold back a pulley by the difference of their tensions, that behind being the k-th part of
// that ahead (Eytelwein: k = exp(μ θ)).
void add_ropes(const Sliding& s, FrictionLaw& law) {
  const double rate = s.twist.angular.dot(s.unit().angular);
  for (const RopeFriction& rope : s.friction.ropes) {
    const bool runs_on = rate * rope.radius > 0.0;
    const std::optional<CouplingId>& ahead = runs_on ? rope.leaves : rope.arrives;
    const std::optional<CouplingId>& behind = runs_on ? rope.arrives : rope.leaves;
    const double share = ahead ? 1.0 - 1.0 / rope.ratio : rope.ratio - 1.0;
    law.parts.push_back(
        tension_part(s.mechanism, ahead ? *ahead : *behind, std::abs(rope.radius) * share));
  }
}

FrictionLaw revolute(const Sliding& s) {
  const Vec3 axis = s.unit().angular;
  const double mu = s.friction.mu;
  FrictionLaw law = turning(s);
  add_ropes(s, law);
  if (mu == 0.0) {
    return law;
  }
  add_across(s, axis, mu * s.friction.radius, law);
  if (s.friction.thrust_radius > 0.0) {
    law.parts.push_back(axial_part(axis, mu * s.friction.thrust_radius));
  } else if (mu > 0.0) {
    law.ignored.push_back({Reaction::axial, axial_part(axis, 0.0).part});
  }
  return law;
}

// The thread raises its load where the axial force works on the head: then the friction angle adds
// to the lead angle, otherwise it is taken off.
FrictionLaw helical(const Sliding& s) {
  FrictionLaw law = turning(s);
  const Vec3 axis = s.unit().angular;
  const double pitch = velocity_at(s.unit(), s.at).dot(axis);
  const double advance = velocity_at(s.twist, s.at).dot(axis);
  const double radius = s.friction.radius;
  if (radius == 0.0) {
    return law;
  }
  const double lead = std::atan(std::abs(pitch) / radius);
  const double angle = std::atan(s.friction.mu);
  // Steeper than the vertical nothing raises the load.
  const double steep = lead + angle;
  const double raising = steep < std::numbers::pi / 2 ? radius * std::tan(steep) - std::abs(pitch)
                                                      : std::numeric_limits<double>::infinity();
  const double lowering = std::abs(pitch) - radius * std::tan(lead - angle);
  PressingPart part = axial_part(axis, advance > 0.0 ? raising : lowering);
  part.weight_if_negative = advance > 0.0 ? lowering : raising;
  part.is_signed = true;
  law.parts = {part};
  return law;
}

FrictionLaw prismatic(const Sliding& s) {
  const Vec3 axis = s.unit().linear;
  const double rate = s.twist.linear.dot(axis);
  const double against = rate > 0.0 ? -1.0 : 1.0;
  const double mu = s.friction.mu;
  FrictionLaw law = law_of(s, unit_force(against * axis, s.at), std::abs(rate), false);
  law.constant = s.friction.viscous * std::abs(rate);
  add_across(s, axis, mu, law);
  if (s.friction.radius > 0.0) {
    law.parts.push_back(torsion_part(s, axis, mu / s.friction.radius));
  } else if (mu > 0.0) {
    law.ignored.push_back({Reaction::torsion, torsion_part(s, axis, 0.0).part});
  }
  return law;
}

// The force that a contact bears; binding has seen to it that there is one.
std::size_t normal_action(const Sliding& s) {
  const Topology& topology = s.mechanism.topology;
  const int end = s.coupling.first_action + s.coupling.action_count;
  int a = s.coupling.first_action;
  const auto is_force = [&](int action) {
    const ActionLabel& label = topology.actions[static_cast<std::size_t>(action)];
    return label.actuator < 0 && !label.is_couple;
  };
  while (a < end && !is_force(a)) {
    ++a;
  }
  KINESTAT_EXPECTS(a < end);
  return static_cast<std::size_t>(a);
}

// Along the velocity of the head's point of contact; presses along the constraint.
FrictionLaw contact(const Sliding& s) {
  const Vec3 velocity = velocity_at(s.twist, s.at);
  const double speed = velocity.norm();
  const Vec3 against = speed > 0.0 ? Vec3(-velocity / speed) : Vec3::Zero();
  FrictionLaw law = law_of(s, unit_force(against, s.at), speed, false);
  const Vec3 normal = s.mechanism.geometry.actions[normal_action(s)].force;
  law.parts = {force_part(normal * normal.transpose(), s.friction.mu)};
  return law;
}

FrictionLaw find_law(const Sliding& s) {
  switch (s.coupling.type) {
    case CouplingType::revolute:
      return revolute(s);
    case CouplingType::helical:
      return helical(s);
    case CouplingType::prismatic:
      return prismatic(s);
    default:
      return contact(s);
  }
}

// The fastest motion of a point of the mechanism's size, to tell sliding from rounding.
double fastest(const Mechanism& mechanism, const KinematicSolution& motion) {
  double speed = 0.0;
  for (const Twist& twist : motion.bodies) {
    speed =
        std::max({speed, twist.angular.norm() * mechanism.geometry.length, twist.linear.norm()});
  }
  return speed;
}

}  // namespace

std::vector<std::optional<FrictionLaw>> find_friction_laws(const Mechanism& mechanism,
                                                           const KinematicSolution& motion) {
  std::vector<std::optional<FrictionLaw>> laws;
  const double scale = fastest(mechanism, motion);
  for (const CouplingFriction& friction : mechanism.frictions) {
    const auto e = static_cast<std::size_t>(friction.coupling.value);
    const Sliding sliding{.mechanism = mechanism,
                          .friction = friction,
                          .coupling = mechanism.topology.couplings[e],
                          .twist = motion.couplings[e],
                          .at = mechanism.geometry.points[e] - mechanism.geometry.origin};
    const FrictionLaw law = find_law(sliding);
    const double speed = law.speed * (law.is_couple ? mechanism.geometry.length : 1.0);
    laws.push_back(speed > kReportZero * scale ? std::optional(law) : std::nullopt);
  }
  return laws;
}

}  // namespace kinestat
