#include "mechanism/internal/geometry_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/tolerance.hpp"

namespace kinestat {

namespace {

using enum CouplingType;

// What a type demands beside its bodies.
struct Demand {
  CouplingType type = revolute;
  bool in_plane = true;
  bool in_space = true;
  bool at = true;
  std::string_view keys;  ///< of directions and ends, as a sketch of what to type
};

// Axes of the types in the catalogue are checked when they are bound.
constexpr auto kDemands = std::to_array<Demand>({
    {revolute, true, true, true, ""},
    {prismatic, true, true, false, ""},
    {helical, false, true, true, "axis: z"},
    {cylindrical, false, true, true, "axis: z"},
    {universal, false, true, true, "axes: [x, z]"},
    {spherical, false, true, true, ""},
    {planar, false, true, false, "normal: z"},
    {point_contact, true, true, true, "normal: y"},
    {cam, true, true, true, "normal: y"},
    {line_contact, false, true, true, "normal: y, line: x"},
    {sphere_in_tube, false, true, true, "axis: z"},
    {pin_in_slot, true, false, true, "slot: x"},
    {rigid, true, true, false, ""},
    {gear, true, true, true, ""},
    {bevel_gear, false, true, true, "axis: [0, 1, 1], line_of_action: x"},
    {worm, false, true, true, "axis: [0, 1, 1], line_of_action: [1, 1, 0]"},
    {rack, true, true, true, "axis: z, line_of_action: x"},
    {clutch, true, true, true, ""},
    {brake, true, true, true, ""},
    {cable, true, true, false, "from: [x, y], to: [x, y]"},
    {screws, true, true, false, "freedoms: [{rotation: z, at: [0, 0, 0]}]"},
});

const Demand& demand_of(CouplingType type) {
  return *std::ranges::find(kDemands, type, &Demand::type);
}

std::string title(const CouplingDescription& coupling) {
  return fmt::format("{} '{}'", word_of(coupling.type), coupling.name.text);
}

// Whether a direction of the type is there.
bool has_directions(const CouplingDescription& coupling) {
  switch (coupling.type) {
    case helical:
    case cylindrical:
    case sphere_in_tube:
      return coupling.axis.has_value();
    case universal:
      return coupling.axes.size() == 2;
    case planar:
    case point_contact:
    case cam:
      return coupling.normal.has_value();
    case line_contact:
      return coupling.normal && coupling.line;
    case pin_in_slot:
      return coupling.slot.has_value();
    case bevel_gear:
    case worm:
      return (coupling.axis || coupling.screw) && coupling.line_of_action;
    case rack:
      return coupling.line_of_action.has_value();
    case cable:
      return coupling.from && coupling.to;
    case screws:
      return !coupling.freedoms.empty() || !coupling.constraints.empty();
    case revolute:
    case prismatic:
    case spherical:
    case rigid:
    case gear:
    case clutch:
    case brake:
      break;
  }
  return true;
}

class GeometryCheck {
 public:
  GeometryCheck(const CouplingDescription& coupling, Evaluator& evaluator, Diagnostics& found)
      : coupling_(coupling), evaluator_(evaluator), found_(found) {}

  void run(Space space) {
    check_space(space);
    if (!has_directions(coupling_) && !is_counted_only(coupling_)) {
      refuse(fmt::format("{} lacks its geometry", title(coupling_)),
             fmt::format("write for example {}", demand_of(coupling_.type).keys));
    }
    check_directions();
    check_helix();
    check_cable();
    for (const auto* list : {&coupling_.freedoms, &coupling_.constraints}) {
      std::ranges::for_each(*list, [&](const ScrewDescription& screw) { check(screw); });
    }
    if (coupling_.screw) {
      check(*coupling_.screw);
    }
    check_friction();
    for (const StiffnessDescription& one : coupling_.stiffness) {
      check_stiffness(one);
    }
  }

 private:
  void refuse(std::string message, std::string hint) {
    found_.error("E0314", coupling_.name.where, std::move(message), std::move(hint));
  }

  void check_space(Space space) {
    const Demand& demand = demand_of(coupling_.type);
    if (space == Space::planar && !demand.in_plane) {
      refuse(fmt::format("{} needs a spatial mechanism", title(coupling_)),
             "write 'space: spatial' at the top of the file, or choose a planar type");
    }
    if (space == Space::spatial && !demand.in_space) {
      refuse(fmt::format("{} needs a planar mechanism", title(coupling_)),
             "write 'space: planar' at the top of the file; in space a cylindrical or a "
             "sphere_in_tube coupling may serve");
    }
  }

  void check_directions() {
    if (!is_in_catalogue(coupling_.type)) {
      check(coupling_.axis);
      check(coupling_.line_of_action);
    }
    check(coupling_.normal);
    check(coupling_.line);
    check(coupling_.slot);
    for (const AxisDescription& axis : coupling_.axes) {
      (void)evaluator_.axis(axis);
    }
    if (coupling_.helix_angle) {
      (void)evaluator_.number(*coupling_.helix_angle, QuantityKind::angle);
    }
  }

  void check(const std::optional<AxisDescription>& direction) {
    if (direction) {
      (void)evaluator_.axis(*direction);
    }
  }

  void check_helix() {
    if (coupling_.type != helical) {
      return;
    }
    if (coupling_.pitch.has_value() == coupling_.lead.has_value()) {
      refuse(coupling_.pitch ? fmt::format("{} has both a pitch and a lead", title(coupling_))
                             : fmt::format("{} lacks its pitch", title(coupling_)),
             "write lead: 5 mm (per turn) or pitch: 0.8 mm (per radian)");
    }
    if (coupling_.pitch) {
      (void)evaluator_.number(*coupling_.pitch, QuantityKind::pitch);
    }
    if (coupling_.lead) {
      (void)evaluator_.number(*coupling_.lead, QuantityKind::lead);
    }
  }

  void check_cable() {
    if (!coupling_.from || !coupling_.to) {
      return;
    }
    const auto from = evaluator_.point(*coupling_.from);
    const auto to = evaluator_.point(*coupling_.to);
    if (from && to && *from == *to) {
      found_.error("E0314",
                   coupling_.to->where,
                   fmt::format("the ends of {} are the same point", title(coupling_)),
                   "a cable needs a direction: move one of its ends");
    }
  }

  void check(const ScrewDescription& screw) {
    (void)evaluator_.axis(screw.direction);
    if (screw.at) {
      (void)evaluator_.point(*screw.at);
    }
    if (screw.pitch) {
      (void)evaluator_.number(*screw.pitch, QuantityKind::pitch);
    }
  }

  void check_friction() {
    if (!coupling_.friction) {
      return;
    }
    const FrictionDescription& friction = *coupling_.friction;
    check_not_negative(friction.mu, QuantityKind::dimensionless);
    check_not_negative(friction.radius, QuantityKind::length);
    check_not_negative(friction.length, QuantityKind::length);
    check_not_negative(friction.tau, QuantityKind::moment);
    if (friction.c) {
      (void)evaluator_.quantity(*friction.c);
    }
  }

  void check_not_negative(const std::optional<Value>& value, QuantityKind kind) {
    const auto number = value ? evaluator_.number(*value, kind) : std::nullopt;
    if (number && *number < 0.0) {
      found_.error("E0305",
                   value->where,
                   fmt::format("a number of the friction of {} is negative", title(coupling_)),
                   "friction acts against the motion by itself; write a positive number");
    }
  }

  // Forces are along translations [N/m], couples along rotations [N·m/rad]: T is a couple.
  void check_stiffness(const StiffnessDescription& one) {
    const bool is_couple = one.action.text.starts_with('T');
    const auto number = evaluator_.number(
        one.value, is_couple ? QuantityKind::angular_stiffness : QuantityKind::stiffness);
    if (number && *number <= 0.0) {
      found_.error(
          "E0305",
          one.value.where,
          fmt::format(
              "the stiffness '{}' of {} is not positive", one.action.text, title(coupling_)),
          "leave a rigid action out; a constraint without stiffness is none");
    }
  }

  const CouplingDescription& coupling_;
  Evaluator& evaluator_;
  Diagnostics& found_;
};

}  // namespace

bool is_counted_only(const CouplingDescription& coupling) {
  return !coupling.at && demand_of(coupling.type).at;
}

bool check_geometry(const CouplingDescription& coupling,
                    Space space,
                    Evaluator& evaluator,
                    Diagnostics& found) {
  const int errors_before = found.error_count();
  GeometryCheck(coupling, evaluator, found).run(space);
  return found.error_count() == errors_before;
}

}  // namespace kinestat
