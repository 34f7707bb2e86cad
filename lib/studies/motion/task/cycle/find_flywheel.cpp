#include "studies/motion/task/cycle/find_flywheel.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/motion_tolerance.hpp"
#include "core/tolerance.hpp"
#include "math/numbers/zero_within_bound.hpp"

namespace kinestat {

namespace {

// What is followed along the cycle, at the drive.
enum Function : std::size_t { supply, inertia, derivative, motor_ratio, wheel_ratio };

constexpr int kProbes = 12;
constexpr double kWidest = 1.0 / 64.0;

class FlywheelFinder {
 public:
  FlywheelFinder(CycleSampler& sampler, const FlywheelPlan& plan)
      : sampler_(sampler),
        topology_(sampler.mechanism().topology),
        plan_(plan),
        speed_(sampler.drive_speed()),
        way_(sampler.drive_at(1.0) - sampler.drive_at(0.0)) {}

  std::variant<FlywheelFigures, CycleProblem> run() {
    if (auto problem = find_motor()) {
      return *std::move(problem);
    }
    found_ = sampler_.find([this](const MotionPosition& at) { return read(at, speed_); });
    if (!found_) {
      return CycleProblem{
          "in some position of the cycle the drive has no action, or it jumps too often, or "
          "rounding leaves it too few digits",
          "the rows of the motion say where; begin it elsewhere, or drive what "
          "determines the motion"};
    }
    if (auto problem = find_problem()) {
      return *std::move(problem);
    }
    return solve();
  }

 private:
  const ActuatorTopology& actuator(int index) const {
    return topology_.actuators[static_cast<std::size_t>(index)];
  }

  std::optional<CycleProblem> find_motor() {
    const std::vector<CycleMotor> motors = cycle_motors(sampler_);
    if (motors.empty()) {
      return CycleProblem{"the case of the motion gives the action of every drive that moves",
                          "leave the action of the one out that drives"};
    }
    if (motors.size() > 1) {
      return CycleProblem{
          fmt::format("both '{}' and '{}' could drive: the case of the motion gives the action of "
                      "neither",
                      actuator(motors[0].actuator).name,
                      actuator(motors[1].actuator).name),
          fmt::format("give all but one, for example action: {{{}: 0}}",
                      actuator(motors[1].actuator).name)};
    }
    motor_ = motors.front().actuator;
    return std::nullopt;
  }

  std::optional<double> rate_of(int index, const MotionPosition& at) const {
    const auto freedom = static_cast<std::size_t>(actuator(index).freedom);
    return freedom < at.state.rates.size() ? at.state.rates[freedom] : std::nullopt;
  }

  std::optional<std::vector<CycleValue>> read(const MotionPosition& at, double speed) const {
    const std::optional<double> motor = rate_of(motor_, at);
    const std::optional<double> wheel = rate_of(plan_.actuator, at);
    if (!at.solved || !at.solved->dynamics || !at.solved->action || !motor || !wheel ||
        at.solved->action->magnitudes.empty()) {
      return std::nullopt;
    }
    const LossyState* const lossy = lossy_state_of(at);
    if (lossy == nullptr && !sampler_.mechanism().lossy_meshes.empty()) {
      return std::nullopt;
    }
    const std::optional<double>& action =
        (lossy != nullptr
             ? lossy->actions
             : at.solved->action->magnitudes)[static_cast<std::size_t>(actuator(motor_).action)];
    const ReducedEquation& reduced = at.solved->dynamics->reduced.value();
    if (!action || !reduced.derivative) {
      return std::nullopt;
    }
    const double torque = *action * *motor / speed;
    const double size = std::max(std::abs(torque), std::abs(reduced.bias[0]));
    const double mass = reduced.inertia(0, 0);
    return std::vector<CycleValue>{{.value = torque, .size = size},
                                   {.value = mass, .size = mass},
                                   {.value = *reduced.derivative, .size = mass},
                                   {.value = *motor / speed, .size = std::abs(*motor / speed)},
                                   {.value = *wheel / speed, .size = std::abs(*wheel / speed)}};
  }

  bool is_steady(Function ratio) const {
    const double first = found_->value(ratio, 0.0);
    bool is_same = first != 0.0;
    found_->for_each_point(1.0, [&](double, double, const VecX& values) {
      is_same = is_same && std::abs(values[static_cast<Eigen::Index>(ratio)] - first) <=
                               kSteady * std::abs(first);
    });
    return is_same;
  }

  std::optional<CycleProblem> find_problem() const {
    for (const auto& [ratio, index] :
         {std::pair(motor_ratio, motor_), std::pair(wheel_ratio, plan_.actuator)}) {
      if (!is_steady(ratio)) {
        return CycleProblem{
            fmt::format("'{}' does not turn in a steady ratio to the drive of the motion",
                        actuator(index).name),
            ratio == motor_ratio
                ? "give its action in the case, and leave open that of a drive that does"
                : "put the flywheel at an actuator that does"};
      }
    }
    return why_not_closed(*found_, sampler_.mechanism());
  }

  double ratio_of(Function ratio, int index) const {
    const bool is_drive = actuator(index).freedom == sampler_.motion().plan.drives.front().freedom;
    return is_drive ? 1.0 : found_->value(ratio, 0.0);
  }

  // What the drive has given too much since the begin [J].
  double surplus(double time) const {
    return way_ * (found_->integral(supply, time) - mean_ * time);
  }

  FlywheelFigures solve() {
    mean_ = found_->integral(supply);
    const GreatestValue most = found_->greatest([this](double t) { return surplus(t); });
    const GreatestValue least = found_->greatest([this](double t) { return -surplus(t); });
    const double energy = zero_within_bound(most.value + least.value,
                                            kNoHarmonic * found_->size(supply) * std::abs(way_));
    const double to_motor = ratio_of(motor_ratio, motor_);
    const double to_wheel = ratio_of(wheel_ratio, plan_.actuator);
    const double wheel_speed = speed_ * to_wheel;
    FlywheelFigures figures{
        .at = actuator(plan_.actuator).name,
        .motor = actuator(motor_).name,
        .motor_turns =
            topology_.freedoms[static_cast<std::size_t>(actuator(motor_).freedom)].is_rotation,
        .fluctuation = plan_.fluctuation,
        .speed = wheel_speed,
        .mean_action = zero_within_bound(mean_, kNoHarmonic * found_->size(supply)) / to_motor,
        .energy = energy,
        .inertia = energy / (plan_.fluctuation * wheel_speed * wheel_speed),
        .with_it = std::nullopt};
    added_ = figures.inertia * to_wheel * to_wheel;
    if (hangs_on_position_alone()) {
      figures.with_it = solve_speed(to_wheel);
    }
    return figures;
  }

  // Whether what acts beside inertia is the same at half the speed.
  bool hangs_on_position_alone() {
    for (int i = 0; i < kProbes; ++i) {
      const double time = (i + 0.5) / kProbes;
      const std::optional<MotionPosition> slow = sampler_.at(time, CyclePace::half);
      const auto there = slow ? read(*slow, 0.5 * speed_) : std::nullopt;
      if (!there) {
        return false;
      }
      const double inertial = 0.5 * found_->value(derivative, time) * speed_ * speed_;
      const double whole = found_->value(supply, time) - inertial;
      const double half = (*there)[supply].value - 0.25 * inertial;
      if (std::abs(whole - half) > kSteady * found_->size(supply)) {
        return false;
      }
    }
    return true;
  }

  // Of what the speed of the drive is made at a time: ½ (M + J) q'^2 less what it has at the begin.
  double gained(double time, double mass) const {
    return 0.5 * speed_ * speed_ * (mass - found_->value(inertia, 0.0)) - surplus(time);
  }

  double square_speed(double begun, double time) const {
    const double mass = found_->value(inertia, time);
    return 2.0 * (begun + gained(time, mass)) / (mass + added_);
  }

  // Mean speed by mean speed of the case, for a kinetic energy at the begin.
  double mean_speed(double begun) const {
    double time = 0.0;
    found_->for_each_point(kWidest, [&](double t, double weight, const VecX&) {
      time += weight * std::abs(speed_) / std::sqrt(square_speed(begun, t));
    });
    return 1.0 / time;
  }

  // The energy at the begin with which the mean speed is that of the case, by halves.
  std::optional<CycleSpeed> solve_speed(double to_wheel) const {
    double low =
        found_->greatest([this](double t) { return -gained(t, found_->value(inertia, t)); }).value;
    double high = std::max(low, 0.0) + speed_ * speed_ * (found_->value(inertia, 0.0) + added_);
    if (!(high > low)) {
      return std::nullopt;
    }
    while (mean_speed(high) < 1.0) {
      high = low + 2.0 * (high - low);
    }
    for (double middle = 0.5 * (low + high); low < middle && middle < high;
         middle = 0.5 * (low + high)) {
      (mean_speed(middle) < 1.0 ? low : high) = middle;
    }
    const double begun = high;
    const GreatestValue most = found_->greatest([&](double t) { return square_speed(begun, t); });
    const GreatestValue least = found_->greatest([&](double t) { return -square_speed(begun, t); });
    const double greatest = std::sqrt(most.value);
    const double slowest = std::sqrt(-least.value);
    const double wheel = std::abs(to_wheel);
    return CycleSpeed{.greatest = greatest * wheel,
                      .greatest_at = sampler_.drive_at(most.argument),
                      .least = slowest * wheel,
                      .least_at = sampler_.drive_at(least.argument),
                      .fluctuation = (greatest - slowest) / std::abs(speed_)};
  }

  CycleSampler& sampler_;
  const Topology& topology_;
  const FlywheelPlan& plan_;
  double speed_ = 0.0;  // of the drive
  double way_ = 0.0;
  int motor_ = 0;
  double mean_ = 0.0;   // action of the motor at the drive
  double added_ = 0.0;  // inertia of the flywheel at the drive
  std::optional<LegendrePieces> found_;
};

}  // namespace

std::variant<FlywheelFigures, CycleProblem> find_flywheel(CycleSampler& sampler,
                                                          const FlywheelPlan& plan) {
  return FlywheelFinder(sampler, plan).run();
}

}  // namespace kinestat
