#include "mechanism/internal/friction_binder.hpp"

#include <string>

#include <fmt/format.h>

namespace kinestat {

namespace {

using enum CouplingType;

class FrictionBinder {
 public:
  FrictionBinder(const CouplingDescription& coupling,
                 const FileUnits& units,
                 Evaluator& evaluator,
                 Diagnostics& found)
      : coupling_(coupling), units_(units), evaluator_(evaluator), found_(found) {}

  std::optional<CouplingFriction> bind(CouplingId id) {
    const int errors_before = found_.error_count();
    const FrictionDescription& friction = *coupling_.friction;
    CouplingFriction result;
    result.coupling = id;
    result.where = friction.where;
    result.mu = number(friction.mu, QuantityKind::dimensionless).value_or(0.0);
    result.radius = number(friction.radius, QuantityKind::length).value_or(0.0);
    result.length = number(friction.length, QuantityKind::length);
    result.tau = number(friction.tau, QuantityKind::moment).value_or(0.0);
    result.viscous = viscous(friction.c);
    if (result.length && *result.length == 0.0) {
      refuse(friction.length->where,
             fmt::format("the guide of {} has no length", title()),
             "leave 'length' out for a guide whose couple does not count");
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
                                              const FileUnits& units,
                                              Evaluator& evaluator,
                                              Diagnostics& found) {
  return FrictionBinder(coupling, units, evaluator, found).bind(id);
}

}  // namespace kinestat
