#include "mechanism/internal/friction_binder.hpp"

#include <string>

#include <fmt/format.h>

namespace kinestat {

namespace {

using enum CouplingType;

// Which numbers a type uses.
struct Use {
  bool radius = false;
  bool length = false;
  bool tau = false;
  bool c = false;
};

std::optional<Use> use_of(const CouplingDescription& coupling) {
  switch (coupling.type) {
    case revolute:
    case helical:
      return Use{.radius = true, .length = false, .tau = true, .c = true};
    case prismatic:
      return Use{.radius = false, .length = true, .tau = false, .c = true};
    case worm:
    case cam:
    case point_contact:
    case pin_in_slot:
      return Use{};
    case gear:
      return coupling.contact ? std::optional(Use{}) : std::nullopt;
    case cylindrical:
    case universal:
    case spherical:
    case planar:
    case line_contact:
    case sphere_in_tube:
    case rigid:
    case bevel_gear:
    case rack:
    case clutch:
    case brake:
    case cable:
    case screws:
      break;
  }
  return std::nullopt;
}

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
    const std::optional<Use> use = use_of(coupling_);
    CouplingFriction result;
    result.coupling = id;
    result.where = friction.where;
    result.mu = number(friction.mu, QuantityKind::dimensionless, "mu", true).value_or(0.0);
    const auto radius =
        number(friction.radius, QuantityKind::length, "radius", !use || use->radius);
    result.radius = radius.value_or(0.0);
    result.length = number(friction.length, QuantityKind::length, "length", !use || use->length);
    result.tau = number(friction.tau, QuantityKind::moment, "tau", !use || use->tau).value_or(0.0);
    result.viscous = viscous(friction.c, !use || use->c);
    if (use && use->radius && friction.mu && !friction.radius) {
      refuse(friction.where,
             fmt::format("the friction of {} lacks the key 'radius'", title()),
             coupling_.type == helical
                 ? "write friction: {mu: 0.1, radius: 10 mm} with the mean radius of the thread"
                 : "write friction: {mu: 0.1, radius: 10 mm} with the radius of the journal");
    }
    if (result.length && *result.length == 0.0) {
      refuse(friction.length->where,
             fmt::format("the guide of {} has no length", title()),
             "leave 'length' out for a guide whose couple does not count");
    }
    return use && found_.error_count() == errors_before ? std::optional(result) : std::nullopt;
  }

 private:
  std::string title() const {
    return fmt::format("{} '{}'", word_of(coupling_.type), coupling_.name.text);
  }

  void refuse(SourceRange where, std::string message, std::string hint) {
    found_.error("E0305", where, std::move(message), std::move(hint));
  }

  void check(const Value& value, double number, std::string_view key, bool is_used) {
    if (number < 0.0) {
      refuse(value.where,
             fmt::format("a number of the friction of {} is negative", title()),
             "friction acts against the motion by itself; write a positive number");
    } else if (!is_used) {
      refuse(value.where,
             fmt::format("the friction of {} has no use for '{}'", title(), key),
             fmt::format("remove '{}'; 'kinestat help couplings' lists what each type uses", key));
    }
  }

  std::optional<double> number(const std::optional<Value>& value,
                               QuantityKind kind,
                               std::string_view key,
                               bool is_used) {
    const auto number = value ? evaluator_.number(*value, kind) : std::nullopt;
    if (number) {
      check(*value, *number, key, is_used);
    }
    return number;
  }

  // A couple per angular velocity, of a prismatic a force per velocity. A bare number counts in the
  // units of the file.
  double viscous(const std::optional<Value>& value, bool is_used) {
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
    check(*value, number, "c", is_used);
    return number;
  }

  const CouplingDescription& coupling_;
  const FileUnits& units_;
  Evaluator& evaluator_;
  Diagnostics& found_;
};

}  // namespace

bool has_friction_law(const CouplingDescription& coupling) {
  return use_of(coupling).has_value();
}

std::optional<CouplingFriction> bind_friction(const CouplingDescription& coupling,
                                              CouplingId id,
                                              const FileUnits& units,
                                              Evaluator& evaluator,
                                              Diagnostics& found) {
  return FrictionBinder(coupling, units, evaluator, found).bind(id);
}

}  // namespace kinestat
