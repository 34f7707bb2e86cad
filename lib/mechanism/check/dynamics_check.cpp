#include <fmt/format.h>

#include "mechanism/check/section_checks.hpp"

namespace kinestat {

namespace {

void check_flywheel(const FlywheelDescription& flywheel, const SectionContext& context) {
  constexpr NumberRule kRule = {.kind = QuantityKind::dimensionless,
                                .range = kFluctuation,
                                .allowed = "a number above 0 and below 1"};
  context.names.check_actuator(flywheel.at, "'flywheel' of 'dynamics' is at", context.found);
  context.number(flywheel.fluctuation, kRule, "'fluctuation' of 'flywheel'");
  if (context.names.kind_of_actuator(flywheel.at.text) == DriveKind::sliding) {
    context.found.error("E0313",
                        flywheel.at.where,
                        fmt::format("'flywheel' is at '{}', which slides", flywheel.at.text),
                        "name an actuator of a freedom that turns");
  }
}

}  // namespace

void check_dynamics(const SectionContext& context) {
  if (!context.description.dynamics) {
    return;
  }
  const DynamicsDescription& dynamics = *context.description.dynamics;
  for (const Name& actuator : dynamics.actuators) {
    context.names.check_actuator(actuator, "'actuators' of 'dynamics' names", context.found);
  }
  context.repeats(dynamics.actuators, "'actuators' of 'dynamics'");
  if (dynamics.flywheel) {
    check_flywheel(*dynamics.flywheel, context);
  }
  constexpr NumberRule kOrders = {.kind = QuantityKind::dimensionless,
                                  .range = kHarmonics,
                                  .allowed = "a whole number from 1 to 100"};
  context.number(dynamics.harmonics, kOrders, "'harmonics' of 'dynamics'");
  if (dynamics.balance) {
    for (const Name& body : dynamics.balance->bodies) {
      context.names.bodies.check(body, "'balance' of 'dynamics' names", context.found);
    }
    context.repeats(dynamics.balance->bodies, "'balance' of 'dynamics'");
  }
  for (const Name& coupling : dynamics.limit_speed) {
    context.names.couplings.check(coupling, "'limit_speed' of 'dynamics' names", context.found);
  }
  context.repeats(dynamics.limit_speed, "'limit_speed' of 'dynamics'");
}

}  // namespace kinestat
