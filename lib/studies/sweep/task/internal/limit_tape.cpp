#include "studies/sweep/task/internal/limit_tape.hpp"

#include <algorithm>

#include "studies/shift/gear_limits.hpp"
#include "studies/sweep/task/internal/tape_arithmetic.hpp"
#include "studies/sweep/task/sweep_samples.hpp"
#include "studies/sweep/task/sweep_task.hpp"

namespace kinestat {

namespace {

bool do_limits_vary(const SweepTask& task) {
  const ParameterTable table(parameters_of(task.description));
  const std::vector<bool> varies = varying_parameters(task.plan);
  const auto varies_with = [&](const std::string& name) {
    const int i = table.index_of(name);
    return i >= 0 && varies[static_cast<std::size_t>(i)];
  };
  const auto vary = [&](const std::vector<InputValue>& values) {
    return std::ranges::any_of(values, [&](const InputValue& one) {
      return std::ranges::any_of(one.value.expression.names(), varies_with);
    });
  };
  const ShiftLimitsDescription& limits = *task.description.shift->limits;
  return vary(limits.torque) || vary(limits.slip) || vary(limits.speed) ||
         vary(limits.planet_speed);
}

class LimitRecorder {
 public:
  LimitRecorder(const SweepTask& task, const TapedGear& gear, LaneRecorder& recorder)
      : task_(task), gear_(gear), recorder_(recorder) {}

  std::optional<TapeNumber> run() {
    TapeNumber largest = recorder_.constant(0.0);
    for (const LimitedPart& part : find_limited_parts(task_.mechanism, *task_.shift)) {
      const std::optional<TapeNumber> size = size_of(part);
      if (!size) {
        return std::nullopt;
      }
      largest =
          recorder_.larger(largest, recorder_.divide(*size, recorder_.constant(part.limit.most)));
    }
    return largest;
  }

 private:
  const ActuatorTopology& element(const LimitedPart& part) const {
    const ShiftElement& one = task_.shift->elements[static_cast<std::size_t>(part.limit.index)];
    return task_.mechanism.topology.actuators[static_cast<std::size_t>(one.actuator)];
  }

  std::optional<TapeNumber> size_of(const LimitedPart& part) {
    switch (part.limit.kind) {
      case LimitKind::torque:
        return torque_of_element(element(part).action);
      case LimitKind::slip:
        return size_on_tape(gear_.motion.number(element(part).freedom), recorder_);
      case LimitKind::speed:
      case LimitKind::planet_speed:
        return turning(part);
    }
    return std::nullopt;
  }

  std::optional<TapeNumber> torque_of_element(int action) {
    const bool has_losses = !task_.mechanism.lossy_meshes.empty();
    if (gear_.action == nullptr || (has_losses && gear_.lossy_action == nullptr)) {
      return std::nullopt;
    }
    const TapeNumber size = size_on_tape(gear_.action->number(action), recorder_);
    return has_losses
               ? recorder_.larger(size, size_on_tape(gear_.lossy_action->number(action), recorder_))
               : size;
  }

  std::optional<TapeNumber> turning(const LimitedPart& part) {
    const std::vector<TapedScrew>& bodies = gear_.motion.network.bodies;
    const TapedScrew& body = bodies[static_cast<std::size_t>(part.limit.index)];
    const TapedScrew& from = bodies[static_cast<std::size_t>(part.seen_from.value)];
    std::optional<TapeNumber> only;
    for (std::size_t i = 0; i < 3; ++i) {
      const TapeNumber turning = settled_difference(body[i], from[i], recorder_);
      if (!recorder_.is_zero(turning)) {
        if (only) {
          return std::nullopt;
        }
        only = size_on_tape(turning, recorder_);
      }
    }
    return only ? only : recorder_.constant(0.0);
  }

  const SweepTask& task_;
  const TapedGear& gear_;
  LaneRecorder& recorder_;
};

}  // namespace

std::optional<TapeNumber> record_limit_use(const SweepTask& task,
                                           const TapedGear& gear,
                                           LaneRecorder& recorder) {
  return do_limits_vary(task) ? std::nullopt : LimitRecorder(task, gear, recorder).run();
}

}  // namespace kinestat
