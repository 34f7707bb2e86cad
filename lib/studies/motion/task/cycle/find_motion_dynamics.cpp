#include "studies/motion/task/cycle/find_motion_dynamics.hpp"

#include <string_view>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "mechanism/dynamics_plan.hpp"
#include "studies/motion/task/cycle/cycle_sampler.hpp"
#include "studies/motion/task/cycle/find_actuators.hpp"
#include "studies/motion/task/cycle/find_balance.hpp"
#include "studies/motion/task/cycle/find_flywheel.hpp"
#include "studies/motion/task/cycle/find_harmonics.hpp"
#include "studies/motion/task/cycle/find_limit_speed.hpp"

namespace kinestat {

namespace {

class DynamicsFinder {
 public:
  DynamicsFinder(const DynamicsPlan& plan,
                 const MechanismDescription& description,
                 CycleSampler& sampler,
                 Diagnostics& found)
      : plan_(plan), description_(description), sampler_(sampler), found_(found) {}

  MotionDynamics run() {
    const Mechanism& mechanism = sampler_.mechanism();
    const PlannedDrive& drive = sampler_.motion().plan.drives.front();
    MotionDynamics result;
    result.units = description_.units;
    result.is_planar = mechanism.space == Space::planar;
    result.drive_turns =
        mechanism.topology.freedoms[static_cast<std::size_t>(drive.freedom)].is_rotation;
    if (auto problem = why_no_inertia(mechanism, sampler_.motion())) {
      refuse("'dynamics' has no answer", plan_.where, *std::move(problem));
      return result;
    }
    result.duration = sampler_.motion().plan.schedule->duration();
    result.is_steady = !why_not_steady(mechanism, sampler_.motion());
    if (!plan_.actuators.empty()) {
      std::optional<WatchedMotion> watched;
      take("energies",
           plan_.actuators.front().where,
           find_actuators(sampler_, plan_.actuators),
           watched);
      if (watched) {
        result.actuators = std::move(watched->actuators);
        result.energy = watched->energy;
      }
    }
    if (plan_.flywheel || plan_.harmonics > 0) {
      add_cycle(result);
    }
    if (!plan_.counterweights.empty()) {
      take("counterweights",
           plan_.counterweights.front().where,
           find_balance(sampler_, plan_.counterweights),
           result.balance);
    }
    if (!plan_.limited.empty()) {
      take("limit speed",
           plan_.limited.front().where,
           find_limit_speeds(sampler_, plan_.limited),
           result.limit_speeds);
    }
    return result;
  }

 private:
  void add_cycle(MotionDynamics& result) {
    if (auto problem = why_no_cycle(sampler_)) {
      refuse(plan_.flywheel ? "no flywheel" : "no harmonics",
             plan_.flywheel ? plan_.flywheel->where : plan_.where,
             *std::move(problem));
      return;
    }
    if (plan_.flywheel) {
      take("flywheel",
           plan_.flywheel->where,
           find_flywheel(sampler_, *plan_.flywheel),
           result.flywheel);
    }
    if (plan_.harmonics > 0) {
      take("harmonics", plan_.where, find_harmonics(sampler_, plan_.harmonics), result.harmonics);
    }
  }

  template <class Answer, class To>
  void take(std::string_view what,
            SourceRange where,
            std::variant<Answer, CycleProblem> answer,
            To& to) {
    if (auto* const problem = std::get_if<CycleProblem>(&answer)) {
      refuse(fmt::format("no {}", what), where, std::move(*problem));
    } else {
      to = std::get<Answer>(std::move(answer));
    }
  }

  // What the file asks of its motion it does not ask of another one that options give.
  void refuse(std::string_view what, SourceRange where, CycleProblem problem) {
    if (description_.motion->is_another) {
      found_.warning(
          "W0302",
          plan_.where,
          fmt::format("'dynamics' is skipped for the motion that the options give: {}: {}",
                      what,
                      problem.message),
          "let the motion be that of the file, or one that is told as a whole");
      return;
    }
    found_.error("E0514",
                 problem.where.line > 0 ? problem.where : where,
                 fmt::format("{}: {}", what, problem.message),
                 std::move(problem.hint));
  }

  const DynamicsPlan& plan_;
  const MechanismDescription& description_;
  CycleSampler& sampler_;
  Diagnostics& found_;
};

}  // namespace

std::optional<MotionDynamics> find_motion_dynamics(const MechanismDescription& description,
                                                   const Mechanism& mechanism,
                                                   const FoundMotion& motion,
                                                   Diagnostics& found) {
  const std::optional<DynamicsPlan> plan = bind_dynamics(description, mechanism);
  if (!plan) {
    return std::nullopt;
  }
  CycleSampler sampler(mechanism, motion);
  MotionDynamics dynamics = DynamicsFinder(*plan, description, sampler, found).run();
  return dynamics.is_empty() ? std::nullopt : std::optional(std::move(dynamics));
}

}  // namespace kinestat
