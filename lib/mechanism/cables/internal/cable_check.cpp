#include "mechanism/cables/internal/cable_check.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/tolerance.hpp"
#include "mechanism/gears/internal/gear_binder.hpp"

namespace kinestat {

namespace {

constexpr NumberRule kFriction = {.kind = QuantityKind::dimensionless,
                                  .range = kNotNegative,
                                  .allowed = "a coefficient that is not negative"};

constexpr NumberRule kPulleyEfficiency = {
    .kind = QuantityKind::dimensionless,
    .range = kKeptShare,
    .allowed = "an efficiency above 0 and at most 1: 95 % is 0.95"};

constexpr NumberRule kTurns = {.kind = QuantityKind::dimensionless,
                               .range = kNotNegativeWhole,
                               .allowed = "a whole number, of full turns"};

// The revolute coupling on which a body turns, or null.
const CouplingDescription* bearing_of(const Name& body, const MechanismDescription& description) {
  const auto bearing =
      std::ranges::find_if(description.couplings, [&](const CouplingDescription& coupling) {
        return coupling.type == CouplingType::revolute &&
               (coupling.tail.text == body.text || coupling.head.text == body.text);
      });
  const bool has_one = body.text != description.ground.text;
  return has_one && bearing != description.couplings.end() ? &*bearing : nullptr;
}

void check_axis(const CableStation& pulley,
                const std::string& what,
                const SectionContext& context) {
  if (!pulley.axis) {
    return;
  }
  const std::optional<Axis> axis = context.evaluator.axis(*pulley.axis);
  const bool is_planar = context.description.space == Space::planar;
  if (axis && is_planar && axis->direction.head<2>().norm() > kZeroAxis) {
    context.found.error("E0314",
                        pulley.axis->where,
                        fmt::format("{} of a planar mechanism turns about z", what),
                        "remove 'axis'");
  }
}

// What to type for the centre of a pulley, as drawn.
std::string centre_text(const CouplingDescription* geared_bearing, const SectionContext& context) {
  const bool is_planar = context.description.space == Space::planar;
  // Gears that are wrong have no places.
  const auto frame = geared_bearing != nullptr && !context.found.has_errors()
                         ? bind_gear_frame<double>(context.description, context.evaluator)
                         : std::nullopt;
  if (!frame) {
    return is_planar ? "[x, y]" : "[x, y, z]";
  }
  const Vec3 centre = frame->layout.axis_of(geared_bearing->tail.text, geared_bearing->head.text);
  const FileUnits& units = context.description.units;
  return fmt::format("[{:.10g}, {:.10g}{}]",
                     units.from_si(QuantityKind::length, centre[0]),
                     units.from_si(QuantityKind::length, centre[1]),
                     is_planar ? "" : ", z");
}

void check_centre(const CableStation& pulley,
                  const std::string& what,
                  const SectionContext& context) {
  const bool needs_centre = pulley.points.empty() || pulley.slip;
  const bool is_declared = context.names.bodies.contains(pulley.body.text);
  const CouplingDescription* bearing = bearing_of(pulley.body, context.description);
  const bool is_placed_by_gears =
      bearing != nullptr && bearing->at && bearing->at->is_on_gear_axis();
  if (needs_centre && is_declared && !pulley.at && (bearing == nullptr || is_placed_by_gears)) {
    context.found.error("E0314",
                        pulley.where,
                        fmt::format("{} has no centre: {}",
                                    what,
                                    is_placed_by_gears ? "'gears' places the bearing of its body"
                                                       : "no revolute coupling joins its body"),
                        fmt::format("add 'at: {}', its centre as drawn",
                                    centre_text(is_placed_by_gears ? bearing : nullptr, context)));
  }
}

void check_pulley(const CableStation& pulley,
                  const std::string& cable,
                  const SectionContext& context) {
  const std::string what = fmt::format("pulley '{}' of {}", pulley.body.text, cable);
  context.names.bodies.check(pulley.body, cable + " wraps", context.found);
  context.number(pulley.radius, kAboveZeroLength, "'radius' of " + what);
  context.number(pulley.turns, kTurns, "'turns' of " + what);
  context.number(pulley.friction, kFriction, "'friction' of " + what);
  context.number(pulley.eta, kPulleyEfficiency, "'eta' of " + what);
  for (const PointDescription& point : pulley.points) {
    context.point(point);
  }
  check_axis(pulley, what, context);
  check_centre(pulley, what, context);
}

void check_stations(const CableDescription& cable, const SectionContext& context) {
  const std::string what = fmt::format("cable '{}'", cable.name.text);
  for (const CableStation& station : cable.over) {
    context.point(station.at);
    if (station.is_pulley) {
      check_pulley(station, what, context);
    } else {
      context.names.bodies.check(station.body, what + " ends on", context.found);
    }
  }
}

void check_segments(const CableDescription& cable, const SectionContext& context) {
  const std::size_t count = cable.over.size();
  for (int i = 1; i <= segment_count(cable); ++i) {
    const CableStation& here = cable.over[static_cast<std::size_t>(i) - 1];
    const CableStation& next = cable.over[static_cast<std::size_t>(i) % count];
    if (is_same_end(here, next)) {
      context.found.error(
          "E0314",
          next.body.where,
          fmt::format(
              "segment '{}' joins body '{}' to itself", segment_name(cable, i), next.body.text),
          "remove one of the two stations, or lead the cable over another body between them");
    }
  }
}

}  // namespace

bool check_cables(const SectionContext& context) {
  const int errors_before = context.found.error_count();
  for (const CableDescription& cable : context.description.cables) {
    check_stations(cable, context);
    check_segments(cable, context);
  }
  return context.found.error_count() == errors_before && check_routes(context);
}

}  // namespace kinestat
