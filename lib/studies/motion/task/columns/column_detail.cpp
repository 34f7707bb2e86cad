#include "studies/motion/task/columns/column_detail.hpp"

namespace kinestat {

namespace {

bool knows_speed(const MotionPlan& plan, const Mechanism& mechanism) {
  return plan.which >= 0 &&
         (plan.schedule || !mechanism.cases[static_cast<std::size_t>(plan.which)].motions.empty());
}

}  // namespace

MotionDetail detail_of(const MotionPlan& plan, const Mechanism& mechanism) {
  const MotionReport& report = plan.report;
  const bool has_speed = knows_speed(plan, mechanism);
  const bool has_case = plan.which >= 0;
  const bool has_names = !report.freedoms.empty() || !report.actuators.empty();
  const bool has_statics =
      has_case && (report.action || report.reaction || report.power || report.efficiency ||
                   report.ratio || report.mechanical_advantage || report.dynamics || report.works ||
                   !report.actions.empty() || !report.actuators.empty());
  const bool has_inertia =
      has_statics && mechanism.cases[static_cast<std::size_t>(plan.which)].has_inertia();
  return {.velocity = has_speed && (report.velocity || report.acceleration || report.is_default ||
                                    has_names || has_inertia),
          .acceleration = has_speed && (report.acceleration || has_names || has_inertia),
          .statics = has_statics,
          .reduced_equation = report.dynamics,
          .transmission_angle = has_case && report.transmission_angle};
}

}  // namespace kinestat
