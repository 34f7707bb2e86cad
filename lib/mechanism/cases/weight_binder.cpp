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

// The centre of a gear is on its axis; where along it makes no difference in the plane, nor for a
// weight along it.
bool has_place(const BodyDescription& body, const SectionContext& context, const Vec3& gravity) {
  const bool tilts =
      context.description.space == Space::spatial && (gravity[0] != 0.0 || gravity[1] != 0.0);
  return body.centre_of_mass || (!tilts && is_on_axis(context.description, body.name.text));
}

void complain_of_missing_centre(const BodyDescription& body, const SectionContext& context) {
  const bool is_planar = context.description.space == Space::planar;
  const bool is_gear = is_on_axis(context.description, body.name.text);
  context.found.error(
      "E0303",
      body.mass->where,
      fmt::format("body '{}' has a mass, on which gravity acts{}, but no centre of mass",
                  body.name.text,
                  is_gear ? " across its axis" : ""),
      fmt::format("add centre_of_mass: {}, a point in the drawn position{}, or remove the mass",
                  is_planar ? "[x, y]" : "[x, y, z]",
                  is_gear ? " (z decides on the forces in its bearings)" : ""));
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
    const bool hangs = body.mass && acceleration && has_place(body, context, *acceleration);
    if (body.mass && acceleration && !hangs) {
      complain_of_missing_centre(body, context);
    }
    if (hangs) {
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

// Gives each weight of a gear its place in the train.
class GearWeights {
 public:
  GearWeights(const SectionContext& context, const std::vector<BodyMass>& masses)
      : context_(context),
        masses_(masses),
        frame_(bind_gear_frame<double>(context.description, context.evaluator)) {
    KINESTAT_EXPECTS(frame_.has_value());
  }

  void place(Load& weight) const {
    const std::string body = weight.name.substr(kWeightPrefix.size());
    const auto& bodies = context_.description.bodies;
    const auto described =
        std::ranges::find(bodies, body, [](const BodyDescription& one) { return one.name.text; });
    KINESTAT_EXPECTS(described != bodies.end());
    if (!described->centre_of_mass) {
      weight.point = place_on_axis(layout(), layout().train.axis_on(body), context_.evaluator);
    }
    const int count = masses_[at(weight.acts.body.value)].count;
    if (count > 1) {
      carry(body, count, weight);
    }
    weight.acts.wrench.moment =
        moment_of_load(*weight.point, weight.acts.wrench.force, Vec3::Zero());
  }

 private:
  const GearLayout& layout() const { return frame_->layout; }

  // The weight of one planet as that of all on their carrier.
  void carry(const std::string& body, int count, Load& weight) const {
    const std::string& carrier = layout().train.axes[at(layout().train.axis_on(body))].carrier;
    weight.point = place_of_planet_weights(layout(), body, context_.evaluator, *weight.point);
    weight.acts.body = BodyId{context_.names.bodies.find(carrier)};
    weight.acts.wrench.force *= count;
  }

  const SectionContext& context_;
  const std::vector<BodyMass>& masses_;
  std::optional<GearFrame> frame_;
};

}  // namespace

void place_gear_weights(const SectionContext& context,
                        const std::vector<BodyMass>& masses,
                        std::vector<CaseLoads>& cases) {
  if (!context.description.gears || !context.description.gravity) {
    return;
  }
  const GearWeights gears(context, masses);
  for (CaseLoads& one : cases) {
    for (Load& load : one.loads) {
      if (load.name.starts_with(kWeightPrefix)) {
        gears.place(load);
      }
    }
    std::erase_if(one.loads, [](const Load& load) { return load.acts.body.value == 0; });
  }
}

}  // namespace kinestat
