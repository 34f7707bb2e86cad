#include "mechanism/check/section_checks.hpp"

namespace kinestat {

namespace {

void check_values(const std::vector<InputValue>& values, const SectionContext& context) {
  for (const InputValue& one : values) {
    context.evaluator.quantity(one.value);
    if (one.target) {
      context.names.check_actuator(*one.target, "a point of 'duty' names", context.found);
    }
  }
}

}  // namespace

void check_duty(const SectionContext& context) {
  if (!context.description.duty) {
    return;
  }
  const DutyDescription& duty = *context.description.duty;
  constexpr NumberRule kPositive = {
      .kind = QuantityKind::dimensionless, .range = kAboveZero, .allowed = "a number above zero"};
  context.number(duty.repetitions, kPositive, "'repetitions' of 'duty'");
  context.number(duty.gear_exponent, kPositive, "'gear_exponent' of 'duty'");
  context.number(duty.bearing_exponent, kPositive, "'bearing_exponent' of 'duty'");
  for (const DutyPointDescription& point : duty.points) {
    context.number(point.duration, kDuration, "'duration' of a point of 'duty'");
    check_values(point.input_motion, context);
    check_values(point.input_action, context);
  }
}

}  // namespace kinestat
