#include "mechanism/couplings/internal/friction_binder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "core/tolerance.hpp"
#include "couplings/kinds.hpp"
#include "math/numbers/dual.hpp"
#include "mechanism/bind/bare_damping.hpp"

namespace kinestat {

namespace {

std::string title_of(const CouplingDescription& coupling) {
  return fmt::format("{} '{}'", word_of(coupling.type), coupling.name.text);
}

void refuse(Diagnostics& found, SourceRange where, std::string message, std::string hint) {
  found.error("E0305", where, std::move(message), std::move(hint));
}

template <class Scalar>
class FrictionReader {
 public:
  FrictionReader(const CouplingDescription& coupling,
                 const FileUnits& units,
                 EvaluatorOf<Scalar>& evaluator,
                 Diagnostics& found)
      : coupling_(coupling), units_(units), evaluator_(evaluator), found_(found) {}

  CouplingFrictionOf<Scalar> read(CouplingId id) {
    const FrictionDescription& friction = *coupling_.friction;
    CouplingFrictionOf<Scalar> result;
    result.coupling = id;
    result.where = friction.where;
    result.mu = number(friction.mu, QuantityKind::dimensionless).value_or(0.0);
    result.mu_static = number(friction.mu_static, QuantityKind::dimensionless);
    result.radius = number(friction.radius, QuantityKind::length).value_or(0.0);
    result.thrust_radius = number(friction.thrust_radius, QuantityKind::length).value_or(0.0);
    result.length = number(friction.length, QuantityKind::length);
    read_tau(result);
    result.viscous = viscous(friction.c);
    return result;
  }

 private:
  void read_tau(CouplingFrictionOf<Scalar>& result) {
    const std::optional<Value>& tau = coupling_.friction->tau;
    const bool is_law = tau && std::ranges::count(tau->expression.names(), kSpeedOfFriction) > 0;
    if (!is_law) {
      result.tau = number(tau, QuantityKind::moment).value_or(0.0);
      return;
    }
    const Dimension dimension = dimension_of(QuantityKind::angular_velocity);
    const std::array sample = {LawVariable<Scalar>{
        .name = kSpeedOfFriction, .value = {.value = 1.0, .dimension = dimension}}};
    result.tau_of_speed = evaluator_.law(*tau, QuantityKind::moment, sample);
    if (result.tau_of_speed) {
      result.tau = tau_at(result, Scalar(0.0)).value_or(std::numeric_limits<double>::infinity());
    }
  }

  void check_not_negative(const Value& value, double number) {
    if (number < 0.0) {
      refuse(found_,
             value.where,
             fmt::format("a number of the friction of {} is negative", title_of(coupling_)),
             "friction acts against the motion by itself; write a positive number");
    }
  }

  std::optional<Scalar> number(const std::optional<Value>& value, QuantityKind kind) {
    const auto number = value ? evaluator_.number(*value, kind) : std::nullopt;
    if (number) {
      check_not_negative(*value, value_of(*number));
    }
    return number;
  }

  // A couple per angular velocity, of a prismatic a force per velocity. A bare number counts in the
  // units of the file.
  Scalar viscous(const std::optional<Value>& value) {
    const auto quantity = value ? evaluator_.quantity(*value) : std::nullopt;
    if (!quantity) {
      return 0.0;
    }
    const bool slides = kind_ == FrictionKind::guide;
    const QuantityKind action = slides ? QuantityKind::force : QuantityKind::moment;
    const QuantityKind rate = slides ? QuantityKind::velocity : QuantityKind::angular_velocity;
    Scalar number = quantity->value;
    if (is_bare(quantity->dimension)) {
      number = number * Scalar(bare_damping_unit(units_, !slides));
    } else if (quantity->dimension != dimension_of(action) / dimension_of(rate)) {
      found_.error("E0309",
                   value->where,
                   fmt::format("'c' of the friction of {} is a {} per {}",
                               title_of(coupling_),
                               slides ? "force" : "couple",
                               slides ? "velocity" : "angular velocity"),
                   slides ? "write for example c: 5 N*s/m" : "write for example c: 0.1 N*m*s/rad");
    }
    check_not_negative(*value, value_of(number));
    return number;
  }

  const CouplingDescription& coupling_;
  FrictionKind kind_ = kind_of(coupling_.type).friction;
  const FileUnits& units_;
  EvaluatorOf<Scalar>& evaluator_;
  Diagnostics& found_;
};

// Whether the numbers make sense together.
class FrictionCheck {
 public:
  FrictionCheck(const CouplingDescription& coupling,
                const CouplingScrews& screws,
                Diagnostics& found)
      : coupling_(coupling), screws_(screws), found_(found) {}

  void check(const CouplingFriction& bound) {
    const FrictionDescription& friction = *coupling_.friction;
    if (bound.length && *bound.length == 0.0) {
      refuse(found_,
             friction.length->where,
             fmt::format("the friction of {} has a length of zero", title_of(coupling_)),
             "leave 'length' out if friction is to ignore the tilting moment");
    }
    check_numbers(friction, bound);
    check_radius(friction);
    if (bound.mu_static && *bound.mu_static < bound.mu) {
      refuse(
          found_,
          friction.mu_static->where,
          fmt::format("friction of {} would be less at rest than in motion", title_of(coupling_)),
          "'mu_static' is no less than 'mu'");
    }
    check_place(friction);
    check_arms(friction);
    const bool presses = bound.mu > 0.0 || bound.mu_static.value_or(0.0) > 0.0;
    if (presses && has_friction_law(coupling_) && !has_pressing_action(bound)) {
      if (friction.radius && bound.radius == 0.0) {
        refuse(found_,
               friction.radius->where,
               fmt::format("the friction of {} has a radius of zero", title_of(coupling_)),
               "write the radius at which it acts, or remove the friction");
        return;
      }
      refuse(
          found_,
          bound.mu > 0.0 ? friction.mu->where : friction.mu_static->where,
          fmt::format("no normal force acts in {}: it bears no action that its friction depends on",
                      title_of(coupling_)),
          coupling_.passive
              ? "add the action that presses to 'passive:'"
              : "give the radius at which the friction acts, or remove the coefficient");
    }
  }

 private:
  // A collar that bears a thrust alone has none.
  void check_radius(const FrictionDescription& friction) {
    if (kind_ == FrictionKind::journal && friction.mu && !friction.radius &&
        !screws_.freedoms.empty() && (bears(false, false) || bears(true, false))) {
      found_.error("E0303",
                   friction.where,
                   fmt::format("the friction of {} lacks the key 'radius'", title_of(coupling_)),
                   "for example 'radius: 20 mm'; a collar without a journal bears the axial force "
                   "alone, as 'passive: [Rz]' says of one along z");
    }
  }

  // A couple that presses is one about the place of the coupling.
  void check_place(const FrictionDescription& friction) {
    const bool is_without = kind_ == FrictionKind::guide && !coupling_.at;
    const std::optional<Value>& value = friction.length ? friction.length : friction.radius;
    if (is_without && value) {
      refuse(found_,
             value->where,
             fmt::format("the friction of {} depends on a couple, but the coupling has no place",
                         title_of(coupling_)),
             "add 'at:', the middle of the guide");
    }
  }

  // A length at which an action presses that the coupling never bears, as across the plane.
  void check_arms(const FrictionDescription& friction) {
    const bool is_journal = kind_ == FrictionKind::journal;
    if ((!is_journal && kind_ != FrictionKind::guide) || screws_.freedoms.empty()) {
      return;
    }
    const auto demand = [&](const std::optional<Value>& value,
                            std::string_view key,
                            bool is_borne,
                            std::string_view action) {
      if (value && !is_borne) {
        refuse(found_,
               value->where,
               fmt::format("'{}' of the friction of {} has no effect: the coupling bears no {}",
                           key,
                           title_of(coupling_),
                           action),
               fmt::format("remove '{}'", key));
      }
    };
    demand(friction.length, "length", bears(true, false), "tilting moment");
    if (is_journal) {
      demand(friction.thrust_radius, "thrust_radius", bears(false, true), "axial force");
    } else {
      demand(friction.radius, "radius", bears(true, true), "torque about its axis");
    }
  }

  // Whether it bears a couple, or a force, with a part along its axis or across it.
  bool bears(bool is_couple, bool is_along) const {
    const NamedTwist& freedom = screws_.freedoms.front();
    const Vec3 axis =
        (freedom.is_rotation ? freedom.screw.angular : freedom.screw.linear).normalized();
    return std::ranges::any_of(screws_.constraints, [&](const NamedWrench& one) {
      const Vec3& direction = one.is_couple ? one.screw.moment : one.screw.force;
      const double share = is_along ? std::abs(direction.dot(axis)) : direction.cross(axis).norm();
      return one.is_couple == is_couple && share > kParallelAxes * direction.norm();
    });
  }

  // Whether the coupling bears one of the actions that its law counts.
  bool has_pressing_action(const CouplingFriction& friction) const {
    const bool turns = kind_ == FrictionKind::journal;
    const Vec3 axis = !turns || screws_.freedoms.empty()
                          ? Vec3::Zero()
                          : Vec3(screws_.freedoms.front().screw.angular.normalized());
    return std::ranges::any_of(screws_.constraints, [&](const NamedWrench& one) {
      if (kind_ == FrictionKind::guide) {
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
      refuse(found_,
             friction.where,
             fmt::format("the friction of {} has no coefficient", title_of(coupling_)),
             kind_ == FrictionKind::journal || kind_ == FrictionKind::thread
                 ? "add 'mu', 'tau' or 'c'"
             : kind_ == FrictionKind::drag  ? "add 'tau' or 'c'"
             : kind_ == FrictionKind::guide ? "add 'mu' or 'c'"
                                            : "add 'mu'");
    }
    if (kind_ == FrictionKind::thread && friction.radius && bound.radius == 0.0) {
      refuse(found_,
             friction.radius->where,
             fmt::format("the thread of {} has the radius zero", title_of(coupling_)),
             "write its mean radius");
    }
  }

  const CouplingDescription& coupling_;
  FrictionKind kind_ = kind_of(coupling_.type).friction;
  const CouplingScrews& screws_;
  Diagnostics& found_;
};

}  // namespace

bool has_friction_law(const CouplingDescription& coupling) {
  // Gears that roll on each other do not slide; their teeth in contact do.
  const bool rolls = coupling.type == CouplingType::gear && !coupling.contact;
  return kind_of(coupling.type).friction != FrictionKind::no_law && !rolls;
}

template <class Scalar>
CouplingFrictionOf<Scalar> read_friction(const CouplingDescription& coupling,
                                         CouplingId id,
                                         const FileUnits& units,
                                         EvaluatorOf<Scalar>& evaluator,
                                         Diagnostics& found) {
  return FrictionReader<Scalar>(coupling, units, evaluator, found).read(id);
}

template CouplingFriction read_friction(
    const CouplingDescription&, CouplingId, const FileUnits&, Evaluator&, Diagnostics&);
template CouplingFrictionOf<Dual> read_friction(
    const CouplingDescription&, CouplingId, const FileUnits&, EvaluatorOf<Dual>&, Diagnostics&);

std::optional<CouplingFriction> bind_friction(const CouplingDescription& coupling,
                                              CouplingId id,
                                              const CouplingScrews& screws,
                                              const FileUnits& units,
                                              Evaluator& evaluator,
                                              Diagnostics& found) {
  const int errors_before = found.error_count();
  const CouplingFriction result = read_friction(coupling, id, units, evaluator, found);
  if (found.error_count() == errors_before) {
    FrictionCheck(coupling, screws, found).check(result);
    if (const std::optional<Value>& c = coupling.friction->c) {
      warn_of_bare_damping(*c,
                           fmt::format("'c' of the friction of {}", title_of(coupling)),
                           kind_of(coupling.type).friction != FrictionKind::guide,
                           units,
                           evaluator,
                           found);
    }
  }
  return has_friction_law(coupling) && found.error_count() == errors_before ? std::optional(result)
                                                                            : std::nullopt;
}

}  // namespace kinestat
