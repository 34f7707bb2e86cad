#include "mechanism/internal/friction_binder.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "core/tolerance.hpp"

namespace kinestat {

namespace {

using enum CouplingType;

class FrictionBinder {
 public:
  FrictionBinder(const CouplingDescription& coupling,
                 const CouplingScrews& screws,
                 const FileUnits& units,
                 Evaluator& evaluator,
                 Diagnostics& found)
      : coupling_(coupling), screws_(screws), units_(units), evaluator_(evaluator), found_(found) {}

  std::optional<CouplingFriction> bind(CouplingId id) {
    const int errors_before = found_.error_count();
    const FrictionDescription& friction = *coupling_.friction;
    CouplingFriction result;
    result.coupling = id;
    result.where = friction.where;
    result.mu = number(friction.mu, QuantityKind::dimensionless).value_or(0.0);
    result.radius = number(friction.radius, QuantityKind::length).value_or(0.0);
    result.thrust_radius = number(friction.thrust_radius, QuantityKind::length).value_or(0.0);
    result.length = number(friction.length, QuantityKind::length);
    result.tau = number(friction.tau, QuantityKind::moment).value_or(0.0);
    result.viscous = viscous(friction.c);
    if (result.length && *result.length == 0.0) {
      refuse(friction.length->where,
             fmt::format("the friction of {} has a length of zero", title()),
             "leave 'length' out where the couple across the axis does not count");
    }
    check_numbers(friction, result);
    if (result.mu > 0.0 && has_friction_law(coupling_) && !has_pressing_action(result)) {
      refuse(friction.mu->where,
             fmt::format("nothing presses in {}: it bears no action that its friction depends on",
                         title()),
             coupling_.passive ? "add the action that presses to 'passive:'"
                               : "give the radius on which it rubs, or remove the coefficient");
    }
    return has_friction_law(coupling_) && found_.error_count() == errors_before
               ? std::optional(result)
               : std::nullopt;
  }

 private:
  std::string title() const {
    return fmt::format("{} '{}'", word_of(coupling_.type), coupling_.name.text);
  }

  void refuse(SourceRange where, std::string message, std::string hint) {
    found_.error("E0305", where, std::move(message), std::move(hint));
  }

  // Whether the coupling bears one of the actions that its law counts.
  bool has_pressing_action(const CouplingFriction& friction) const {
    const bool turns = coupling_.type == revolute;
    const Vec3 axis = !turns || screws_.freedoms.empty()
                          ? Vec3::Zero()
                          : Vec3(screws_.freedoms.front().screw.angular.normalized());
    return std::ranges::any_of(screws_.constraints, [&](const NamedWrench& one) {
      if (coupling_.type == prismatic) {
        return !one.is_couple || friction.length || friction.radius > 0.0;
      }
      if (!turns || one.is_couple) {
        return turns ? friction.length.has_value() : !one.is_couple;
      }
      const double along = std::abs(one.screw.force.dot(axis));
      const double across = one.screw.force.cross(axis).norm();
      return (friction.radius > 0.0 && across > kParallelAxes) ||
             (friction.thrust_radius > 0.0 && along > kParallelAxes);
    });
  }

  // Friction that can never be anything but zero is a mistake, or a number that is missing.
  void check_numbers(const FrictionDescription& friction, const CouplingFriction& bound) {
    const bool has_force = friction.mu || friction.tau || friction.c;
    if (!has_force) {
      refuse(friction.where,
             fmt::format("the friction of {} has no coefficient", title()),
             coupling_.type == revolute || coupling_.type == helical ? "add 'mu', 'tau' or 'c'"
                                                                     : "add 'mu' or 'c'");
    }
    if (coupling_.type == helical && friction.radius && bound.radius == 0.0) {
      refuse(friction.radius->where,
             fmt::format("the thread of {} has the radius zero", title()),
             "write its mean radius");
    }
  }

  void check_not_negative(const Value& value, double number) {
    if (number < 0.0) {
      refuse(value.where,
             fmt::format("a number of the friction of {} is negative", title()),
             "friction acts against the motion by itself; write a positive number");
    }
  }

  std::optional<double> number(const std::optional<Value>& value, QuantityKind kind) {
    const auto number = value ? evaluator_.number(*value, kind) : std::nullopt;
    if (number) {
      check_not_negative(*value, *number);
    }
    return number;
  }

  // A couple per angular velocity, of a prismatic a force per velocity. A bare number counts in the
  // units of the file.
  double viscous(const std::optional<Value>& value) {
    const auto quantity = value ? evaluator_.quantity(*value) : std::nullopt;
    if (!quantity) {
      return 0.0;
    }
    const bool slides = coupling_.type == prismatic;
    const QuantityKind action = slides ? QuantityKind::force : QuantityKind::moment;
    const QuantityKind rate = slides ? QuantityKind::velocity : QuantityKind::angular_velocity;
    double number = quantity->value;
    if (is_bare(quantity->dimension)) {
      number *= units_.factor(action) / units_.factor(rate);
    } else if (quantity->dimension != dimension_of(action) / dimension_of(rate)) {
      found_.error("E0309",
                   value->where,
                   fmt::format("'c' of the friction of {} is a {} per {}",
                               title(),
                               slides ? "force" : "couple",
                               slides ? "velocity" : "angular velocity"),
                   slides ? "write for example c: 5 N*s/m" : "write for example c: 0.1 N*m*s/rad");
    }
    check_not_negative(*value, number);
    return number;
  }

  const CouplingDescription& coupling_;
  const CouplingScrews& screws_;
  const FileUnits& units_;
  Evaluator& evaluator_;
  Diagnostics& found_;
};

}  // namespace

bool has_friction_law(const CouplingDescription& coupling) {
  switch (coupling.type) {
    case revolute:
    case helical:
    case prismatic:
    case point_contact:
    case cam:
    case line_contact:
    case pin_in_slot:
    case worm:
      return true;
    case gear:
      return coupling.contact;
    default:
      return false;
  }
}

std::optional<CouplingFriction> bind_friction(const CouplingDescription& coupling,
                                              CouplingId id,
                                              const CouplingScrews& screws,
                                              const FileUnits& units,
                                              Evaluator& evaluator,
                                              Diagnostics& found) {
  return FrictionBinder(coupling, screws, units, evaluator, found).bind(id);
}

}  // namespace kinestat
