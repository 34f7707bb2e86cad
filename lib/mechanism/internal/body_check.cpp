#include "mechanism/internal/body_check.hpp"

#include <fmt/format.h>

namespace kinestat {

namespace {

constexpr NumberRule kMass = {.kind = QuantityKind::mass,
                              .accepts = [](double x) { return x >= 0.0; },
                              .allowed = "a mass that is not negative"};

}  // namespace

void check_bodies(const SectionContext& context) {
  for (const BodyDescription& body : context.description.bodies) {
    (void)context.number(body.mass, kMass, fmt::format("'mass' of body '{}'", body.name.text));
    context.point(body.centre_of_mass);
    for (const PointDescription& point : body.outline) {
      context.point(point);
    }
  }
  if (context.description.gravity) {
    context.components(context.description.gravity->coordinates, QuantityKind::acceleration);
  }
}

}  // namespace kinestat
