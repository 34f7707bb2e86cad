#include <algorithm>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/index.hpp"
#include "mechanism/cases/load_binder.hpp"
#include "mechanism/cases/load_moment.hpp"
#include "mechanism/gears/internal/gear_binder.hpp"
#include "mechanism/gears/planet_weight.hpp"

namespace kinestat {

namespace {

void complain_of_missing_centre(const BodyDescription& body, const SectionContext& context) {
  const bool is_planar = context.description.space == Space::planar;
  context.found.error(
      "E0303",
      body.mass->where,
      fmt::format("body '{}' has a mass, on which gravity acts, but no centre of mass",
                  body.name.text),
      fmt::format("add centre_of_mass: {}, a point in the drawn position, or remove the mass",
                  is_planar ? "[x, y]" : "[x, y, z]"));
}

// Bare numbers that count in a unit other than m/s^2 and are no acceleration of any planet then.
void warn_of_gravity_units(const Vec3& acceleration, const SectionContext& context) {
  constexpr double kLeast = 0.3;   // m/s^2; Pluto has 0.6
  constexpr double kMost = 100.0;  // m/s^2; Jupiter has 25
  const double size = acceleration.norm();
  const std::string& unit = context.description.units.text(QuantityKind::acceleration);
  const PointDescription& gravity = *context.description.gravity;
  const bool is_bare_number = std::ranges::all_of(gravity.coordinates, [&](const Value& component) {
    const std::optional<Quantity> value = context.evaluator.quantity(component);
    return value && is_bare(value->dimension);
  });
  if (is_bare_number && size > 0.0 && (size < kLeast || size > kMost)) {
    context.found.warning(
        "W0304",
        gravity.where,
        fmt::format("gravity is {:.4g} m/s^2, because bare numbers count in {}", size, unit),
        "write the unit, as in -9.81 m/s^2");
  }
}

void warn_of_idle_gravity(const SectionContext& context) {
  const bool has_mass = std::ranges::any_of(
      context.description.bodies, [](const BodyDescription& body) { return !!body.mass; });
  if (!has_mass) {
    context.found.warning("W0301",
                          context.description.gravity->where,
                          "gravity acts on no body, because none has a mass",
                          "give bodies a 'mass' and a 'centre_of_mass', or remove 'gravity'");
  }
}

}  // namespace

std::vector<Load> bind_weights(const SectionContext& context,
                               const std::vector<DescribedMass>& masses) {
  const auto& gravity = context.description.gravity;
  const std::optional<Vec3> acceleration =
      gravity ? context.vector(gravity->coordinates, QuantityKind::acceleration) : std::nullopt;
  if (acceleration) {
    warn_of_gravity_units(*acceleration, context);
    warn_of_idle_gravity(context);
  }
  std::vector<Load> weights;
  for (const DescribedMass& described : masses) {
    const BodyDescription& body = context.description.bodies[described.body];
    if (body.mass && gravity && !body.centre_of_mass) {
      complain_of_missing_centre(body, context);
    }
    if (body.mass && body.centre_of_mass && acceleration) {
      const Vec3& centre = described.mass.centre;
      const Vec3 force = described.mass.mass * *acceleration;
      const Vec3 moment = moment_of_load(centre, force, Vec3::Zero());
      weights.push_back({.name = std::string(kWeightPrefix) + body.name.text,
                         .acts = {.body = BodyId{context.names.bodies.find(body.name.text)},
                                  .wrench = {.moment = moment, .force = force}},
                         .point = centre,
                         .where = body.mass->where});
    }
  }
  return weights;
}

namespace {

// The weight of one planet as that of all on their carrier.
void carry(const SectionContext& context, const GearFrame& frame, int count, Load& weight) {
  const std::string body = weight.name.substr(kWeightPrefix.size());
  const GearTrain& train = frame.layout.train;
  const std::string& carrier = train.axes[at(train.axis_on(body))].carrier;
  weight.point = place_of_planet_weights(frame.layout, body, context.evaluator, *weight.point);
  weight.acts.body = BodyId{context.names.bodies.find(carrier)};
  weight.acts.wrench.force *= count;
  weight.acts.wrench.moment = moment_of_load(*weight.point, weight.acts.wrench.force, Vec3::Zero());
}

}  // namespace

void carry_planet_weights(const SectionContext& context,
                          const std::vector<BodyMass>& masses,
                          std::vector<CaseLoads>& cases) {
  if (std::ranges::none_of(masses, [](const BodyMass& one) { return one.count > 1; })) {
    return;
  }
  const auto frame = bind_gear_frame<double>(context.description, context.evaluator);
  KINESTAT_EXPECTS(frame.has_value());
  for (CaseLoads& one : cases) {
    for (Load& load : one.loads) {
      const int count = masses[at(load.acts.body.value)].count;
      if (load.name.starts_with(kWeightPrefix) && count > 1) {
        carry(context, *frame, count, load);
      }
    }
    std::erase_if(one.loads, [](const Load& load) { return load.acts.body.value == 0; });
  }
}

}  // namespace kinestat
