#include "statics/friction_law.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "couplings/kinds.hpp"
#include "kinematics/bounded_motion.hpp"
#include "math/numbers/dual_vector.hpp"
#include "statics/one_sided_action.hpp"

namespace kinestat {

namespace {

template <class Scalar>
using Mat3Of = Eigen::Matrix<Scalar, 3, 3>;

template <class Scalar>
Mat3Of<Scalar> cross_matrix(const Vec3Of<Scalar>& v) {
  const Scalar zero(0.0);
  Mat3Of<Scalar> result;
  result << zero, -v.z(), v.y(), v.z(), zero, -v.x(), -v.y(), v.x(), zero;
  return result;
}

// Takes the component across a unit vector.
template <class Scalar>
Mat3Of<Scalar> across(const Vec3Of<Scalar>& axis) {
  return Mat3Of<Scalar>::Identity() - axis * axis.transpose();
}

template <class Scalar>
PressingPartOf<Scalar> force_part(const Mat3Of<Scalar>& of_force, const Scalar& weight) {
  PressingPartOf<Scalar> result;
  result.part.template rightCols<3>() = of_force;
  result.weight = weight;
  return result;
}

template <class Scalar>
FrictionLawOf<Scalar> law_of(const SlidingOf<Scalar>& s,
                             const WrenchOf<Scalar>& unit,
                             const Scalar& speed) {
  FrictionLawOf<Scalar> law;
  law.coupling = s.friction.coupling;
  law.unit = unit;
  law.speed = speed;
  law.is_couple = is_couple(kind_of(s.topology.coupling(law.coupling).type).friction);
  return law;
}

// The sense against a rate.
template <class Scalar>
Scalar against(const Scalar& rate) {
  return value_of(rate) > 0.0 ? -1.0 : 1.0;
}

// A couple about the axis, whose constant part is the same for journals and threads.
template <class Scalar>
FrictionLawOf<Scalar> turning(const SlidingOf<Scalar>& s) {
  const Vec3Of<Scalar> axis = s.unit.angular;
  const Scalar rate = s.twist.angular.dot(axis);
  const Scalar sense = against(rate);
  FrictionLawOf<Scalar> law = law_of(s, unit_couple<Scalar>(sense * axis), Scalar(-sense * rate));
  const std::optional<Scalar> tau = tau_at(s.friction, law.speed);
  law.constant = static_cast<double>(s.friction.planets) *
                 (tau.value_or(Scalar(0.0)) + s.friction.viscous * law.speed);
  law.has_value = tau.has_value();
  return law;
}

// It presses at its two ends: R/2 ± (M x a)/length, M the couple across the axis about the middle.
template <class Scalar>
std::vector<PressingPartOf<Scalar>> edges(const SlidingOf<Scalar>& s,
                                          const Vec3Of<Scalar>& axis,
                                          const Scalar& weight) {
  std::vector<PressingPartOf<Scalar>> parts;
  for (const double side : {1.0, -1.0}) {
    const Mat3Of<Scalar> half = Scalar(0.5) * across<Scalar>(axis);
    const Mat3Of<Scalar> of_moment =
        (Scalar(-side) / *s.friction.length) * cross_matrix<Scalar>(axis) * across<Scalar>(axis);
    PressingPartOf<Scalar> edge = force_part(half, weight);
    edge.part.template leftCols<3>() = of_moment;
    edge.part.template rightCols<3>() -= of_moment * cross_matrix<Scalar>(s.at);
    parts.push_back(edge);
  }
  return parts;
}

// The couple across the axis about the place of the coupling.
template <class Scalar>
IgnoredPartOf<Scalar> tilting_part(const SlidingOf<Scalar>& s, const Vec3Of<Scalar>& axis) {
  IgnoredPartOf<Scalar> result{.reaction = Reaction::tilting, .beside = s.friction.beside};
  result.part.template leftCols<3>() = across<Scalar>(axis);
  result.part.template rightCols<3>() = -across<Scalar>(axis) * cross_matrix<Scalar>(s.at);
  return result;
}

// The couple about the axis.
template <class Scalar>
PressingPartOf<Scalar> torsion_part(const SlidingOf<Scalar>& s,
                                    const Vec3Of<Scalar>& axis,
                                    const Scalar& weight) {
  PressingPartOf<Scalar> result;
  result.part.row(0).template leftCols<3>() = axis.transpose();
  result.part.row(0).template rightCols<3>() = -axis.transpose() * cross_matrix<Scalar>(s.at);
  result.weight = weight;
  return result;
}

template <class Scalar>
PressingPartOf<Scalar> axial_part(const Vec3Of<Scalar>& axis, const Scalar& weight) {
  PressingPartOf<Scalar> result;
  result.part.row(0).template rightCols<3>() = axis.transpose();
  result.weight = weight;
  return result;
}

// What presses across the axis, with the coefficient of its friction.
template <class Scalar>
void add_across(const SlidingOf<Scalar>& s,
                const Vec3Of<Scalar>& axis,
                const Scalar& weight,
                FrictionLawOf<Scalar>& law) {
  if (s.friction.length) {
    for (PressingPartOf<Scalar>& edge : edges(s, axis, weight)) {
      edge.beside = s.friction.beside;
      law.parts.push_back(std::move(edge));
    }
    return;
  }
  law.parts.push_back(force_part(across<Scalar>(axis), weight));
  law.parts.back().beside = s.friction.beside;
  if (value_of(weight) > 0.0) {
    law.ignored.push_back(tilting_part(s, axis));
  }
}

// The tension of a segment.
template <class Scalar>
PressingPartOf<Scalar> tension_part(const SlidingOf<Scalar>& s,
                                    CouplingId segment,
                                    const Scalar& weight) {
  const Vec3Of<Scalar> along = s.unit_action(s.topology.coupling(segment).first_action).force;
  PressingPartOf<Scalar> result = axial_part<Scalar>(along, weight);
  result.of = segment;
  return result;
}

// Cables hold back a pulley by a part of their tensions. That behind is the k-th part of that ahead
// where they slip (Eytelwein: k = exp(μ θ)), and on a pulley that nothing else turns. Over its
// radius, one that the cable drives gives off ahead/k - behind, one that drives k behind - ahead.
template <class Scalar>
void add_cables(const SlidingOf<Scalar>& s, FrictionLawOf<Scalar>& law) {
  const double rate = value_of(s.twist.angular.dot(s.unit.angular));
  for (const CableFriction& cable : s.friction.cables) {
    if (cable.unless_slip && s.slips(*cable.unless_slip)) {
      continue;
    }
    const bool runs_on = rate * cable.radius > 0.0;
    const std::optional<CouplingId>& ahead = runs_on ? cable.leaves : cable.arrives;
    const std::optional<CouplingId>& behind = runs_on ? cable.arrives : cable.leaves;
    const double radius = std::abs(cable.radius);
    if (ahead) {
      law.parts.push_back(tension_part(s, *ahead, Scalar(radius * (1.0 - 1.0 / cable.ratio))));
    }
    if (ahead && behind && cable.slips) {
      law.parts.back().slack = behind;
      law.parts.back().slack_share = 1.0 / cable.ratio;
    } else if (behind) {
      law.parts.push_back(tension_part(s, *behind, Scalar(radius * (cable.ratio - 1.0))));
      law.parts.back().is_instead = ahead.has_value();
      law.parts.back().is_signed = ahead.has_value();
    }
  }
}

template <class Scalar>
FrictionLawOf<Scalar> journal(const SlidingOf<Scalar>& s) {
  const Vec3Of<Scalar> axis = s.unit.angular;
  const Scalar mu = s.friction.mu;
  FrictionLawOf<Scalar> law = turning(s);
  add_cables(s, law);
  if (value_of(mu) == 0.0) {
    return law;
  }
  if (!s.friction.is_balanced) {
    add_across(s, axis, Scalar(mu * s.friction.radius), law);
  }
  if (value_of(s.friction.thrust_radius) > 0.0) {
    law.parts.push_back(axial_part(axis, Scalar(mu * s.friction.thrust_radius)));
  } else {
    law.ignored.push_back(
        {.reaction = Reaction::axial, .part = axial_part(axis, Scalar(0.0)).part});
  }
  return law;
}

// The couple per axial force that works on the head, which advances by `rise` per radian: then the
// thread raises the load and the friction angle adds to the lead angle. Of a load that is let down
// the rise is negative, so that the lead angle is taken off.
template <class Scalar>
Scalar couple_of_thread(const SlidingOf<Scalar>& s, const Scalar& rise) {
  using std::atan;
  using std::tan;
  const Scalar& radius = s.friction.radius;
  const Scalar angle = atan(s.friction.mu) + atan(rise / radius);
  // Steeper than the vertical nothing raises the load.
  return value_of(angle) < std::numbers::pi / 2 ? Scalar(radius * tan(angle) - rise)
                                                : Scalar(std::numeric_limits<double>::infinity());
}

template <class Scalar>
FrictionLawOf<Scalar> thread(const SlidingOf<Scalar>& s) {
  FrictionLawOf<Scalar> law = turning(s);
  if (value_of(s.friction.radius) == 0.0) {
    return law;
  }
  const Vec3Of<Scalar> axis = s.unit.angular;
  const Scalar pitch = velocity_at<Scalar>(s.unit, s.at).dot(axis);
  const bool turns_forward = value_of(s.twist.angular.dot(axis)) > 0.0;
  const Scalar rise = turns_forward ? pitch : Scalar(-pitch);
  PressingPartOf<Scalar> part = axial_part(axis, couple_of_thread(s, rise));
  part.weight_if_negative = couple_of_thread(s, Scalar(-rise));
  part.is_signed = true;
  law.parts = {part};
  return law;
}

template <class Scalar>
FrictionLawOf<Scalar> guide(const SlidingOf<Scalar>& s) {
  const Vec3Of<Scalar> axis = s.unit.linear;
  const Scalar rate = s.twist.linear.dot(axis);
  const Scalar sense = against(rate);
  const Scalar mu = s.friction.mu;
  FrictionLawOf<Scalar> law =
      law_of(s, unit_force<Scalar>(sense * axis, s.at), Scalar(-sense * rate));
  law.constant = s.friction.viscous * law.speed;
  add_across(s, axis, mu, law);
  if (value_of(s.friction.radius) > 0.0) {
    law.parts.push_back(torsion_part(s, axis, Scalar(mu / s.friction.radius)));
  } else if (value_of(mu) > 0.0) {
    law.ignored.push_back(
        {.reaction = Reaction::torsion, .part = torsion_part(s, axis, Scalar(0.0)).part});
  }
  return law;
}

// The force that a contact bears; binding has seen to it that there is one.
int normal_action(const Topology& topology, const CouplingTopology& coupling) {
  const int end = coupling.first_action + coupling.action_count;
  int a = coupling.first_action;
  const auto is_force = [&](int action) {
    const ActionLabel& label = topology.actions[static_cast<std::size_t>(action)];
    return label.actuator < 0 && !label.is_couple;
  };
  while (a < end && !is_force(a)) {
    ++a;
  }
  KINESTAT_EXPECTS(a < end);
  return a;
}

// Along the velocity of the head's point of contact; presses along the constraint.
template <class Scalar>
FrictionLawOf<Scalar> contact(const SlidingOf<Scalar>& s) {
  using std::sqrt;
  const Vec3Of<Scalar> velocity = velocity_at<Scalar>(s.twist, s.at);
  const Scalar speed = sqrt(velocity.squaredNorm());
  const Vec3Of<Scalar> direction = value_of(speed) > 0.0
                                       ? Vec3Of<Scalar>(-unit_along<Scalar>(velocity))
                                       : Vec3Of<Scalar>(Vec3Of<Scalar>::Zero());
  FrictionLawOf<Scalar> law = law_of(s, unit_force<Scalar>(direction, s.at), speed);
  const CouplingTopology& coupling = s.topology.coupling(s.friction.coupling);
  const int pressing = normal_action(s.topology, coupling);
  const Vec3Of<Scalar> normal = s.unit_action(pressing).force;
  law.parts = {force_part<Scalar>(normal * normal.transpose(), s.friction.mu)};
  if (kind_of(coupling.type).only_pushes) {
    law.pushed_by = pressing;
  }
  return law;
}

// The couple on the turbine, of the pump or of the stator.
template <class Scalar>
FrictionLawOf<Scalar> fluid(const SlidingOf<Scalar>& s) {
  const ConverterLawOf<Scalar>& converter = *s.friction.converter;
  const std::optional<Scalar> couple = converter.couple(s.converter.pump, s.converter.turbine);
  const Scalar size = couple.value_or(Scalar(0.0));
  const Scalar sense = value_of(size) < 0.0 ? -1.0 : 1.0;
  const Scalar slip = converter.slip(s.converter.pump, s.converter.turbine);
  FrictionLawOf<Scalar> law =
      law_of(s, unit_couple<Scalar>(sense * s.unit.angular), Scalar(-sense * slip));
  law.constant = sense * size;
  law.has_value = couple.has_value();
  return law;
}

FrictionLaw law_at_rest(FrictionLaw law) {
  law.speed = 0.0;
  law.constant = 0.0;
  law.parts.clear();
  return law;
}

// Whether nothing but cables would rub there, and they slip instead.
bool slips_instead(const CouplingFriction& friction, const std::function<bool(CouplingId)>& slips) {
  return friction.mu == 0.0 && friction.tau == 0.0 && !friction.cables.empty() &&
         std::ranges::all_of(friction.cables, [&](const CableFriction& cable) {
           return cable.unless_slip && slips(*cable.unless_slip);
         });
}

// Whether a clutch or brake is known to hold.
bool engages_any(const Topology& topology, std::span<const Primary> motions) {
  return std::ranges::any_of(motions, [&](const Primary& known) {
    const CouplingId owner = topology.freedoms[static_cast<std::size_t>(known.index)].coupling;
    return known.value == 0.0 && kind_of(topology.coupling(owner).type).engages;
  });
}

}  // namespace

template <class Scalar>
FrictionLawOf<Scalar> make_friction_law(const SlidingOf<Scalar>& sliding) {
  switch (kind_of(sliding.topology.coupling(sliding.friction.coupling).type).friction) {
    case FrictionKind::journal:
      return journal(sliding);
    case FrictionKind::thread:
      return thread(sliding);
    case FrictionKind::guide:
      return guide(sliding);
    case FrictionKind::drag:
      return turning(sliding);
    case FrictionKind::fluid:
      return fluid(sliding);
    default:
      return contact(sliding);
  }
}

template FrictionLaw make_friction_law(const SlidingOf<double>&);
template FrictionLawOf<Dual> make_friction_law(const SlidingOf<Dual>&);

ConverterTurnsOf<double> converter_turns(const Mechanism& mechanism,
                                         const KinematicSolution& motion,
                                         const CouplingFriction& friction) {
  const ConverterLaw& converter = *friction.converter;
  const auto e = static_cast<std::size_t>(friction.coupling.value);
  const auto freedom = static_cast<std::size_t>(mechanism.topology.couplings[e].first_freedom);
  const Vec3 axis = mechanism.geometry.motions[freedom].angular;
  const BoundedTwist stator = bounded_body(motion, converter.stator);
  const auto turning = [&](BodyId body) {
    return (bounded_body(motion, body) - stator).angular.zeroed().dot(axis);
  };
  return {.pump = turning(converter.pump), .turbine = turning(converter.turbine)};
}

// Drag that grows with the speed has no friction at rest, and so needs no direction there; what is
// engaged has no drag, or is at rest without being held.
bool is_free_at_rest(const Topology& topology,
                     std::span<const Primary> motions,
                     const CouplingFriction& friction) {
  const bool is_drag =
      kind_of(topology.coupling(friction.coupling).type).friction == FrictionKind::drag;
  return is_drag || vanishes_at_rest(friction) || engages_any(topology, motions);
}

std::vector<std::optional<FrictionLaw>> find_friction_laws(const Mechanism& mechanism,
                                                           const Case& which,
                                                           const KinematicSolution& motion) {
  std::vector<std::optional<FrictionLaw>> laws;
  const Geometry& geometry = mechanism.geometry;
  const auto slips = [&](CouplingId link) {
    const int freedom = mechanism.topology.coupling(link).first_freedom;
    return !motion.knows_rate(freedom) || bounded_rate(motion, freedom).zeroed() != 0.0;
  };
  for (const CouplingFriction& friction : mechanism.frictions) {
    const auto e = static_cast<std::size_t>(friction.coupling.value);
    const int freedom = mechanism.topology.couplings[e].first_freedom;
    const bool is_fluid = friction.converter != nullptr;
    const FrictionLaw law = make_friction_law(SlidingOf<double>{
        .topology = mechanism.topology,
        .friction = friction,
        .unit = geometry.motions[static_cast<std::size_t>(freedom)],
        .twist = motion.couplings[e],
        .at = geometry.points[e],
        .unit_action = [&](int a) { return geometry.actions[static_cast<std::size_t>(a)]; },
        .converter =
            is_fluid ? converter_turns(mechanism, motion, friction) : ConverterTurnsOf<double>{},
        .slips = slips});
    if (is_fluid) {
      laws.push_back(law.has_value ? std::optional(law) : std::nullopt);
      continue;
    }
    const auto slides = [&] {
      const BoundedTwist twist = bounded_coupling(mechanism, motion, friction.coupling);
      return !velocity_at(twist, geometry.points[e]).zeroed().isZero(0.0);
    };
    const bool moves = law.speed > 0.0 && (law.is_couple || slides());
    if (moves) {
      laws.push_back(law.has_value ? std::optional(law) : std::nullopt);
    } else {
      const bool is_nothing = is_free_at_rest(mechanism.topology, which.motions, friction) ||
                              slips_instead(friction, slips);
      laws.push_back(is_nothing ? std::optional(law_at_rest(law)) : std::nullopt);
    }
  }
  return laws;
}

}  // namespace kinestat
