#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/utf8.hpp"
#include "power/ratio.hpp"
#include "studies/motion/task/motion_findings.hpp"

namespace kinestat {

bool check_report(const MotionPlan& plan,
                  const Mechanism& mechanism,
                  Diagnostics& found,
                  CasePlace place) {
  const MotionReport& report = plan.report;
  const bool needs_ends = report.ratio || report.transmission_angle || report.mechanical_advantage;
  const bool needs_motion =
      report.velocity || report.acceleration || report.power || report.efficiency || needs_ends;
  const bool needs_action = report.action || report.reaction || report.power || report.efficiency ||
                            report.dynamics || !report.actions.empty();
  if (plan.which < 0) {
    if (!needs_motion && !needs_action) {
      return true;
    }
    const std::string label =
        mechanism.cases.empty() ? "LABEL" : printable(mechanism.cases.front().label);
    found.error(
        "E0303",
        plan.where,
        "'motion' reports more than positions and therefore needs the key 'case'",
        fmt::format(
            "{}: case: {}{}",
            mechanism.cases.empty() ? "add a case that gives the speed of the drive, and name it"
                                    : "name the case whose speeds and loads apply",
            label,
            place == CasePlace::sweep ? fmt::format(", or cases: [{}] under 'sweep'", label) : ""));
    return false;
  }
  const Case& which = mechanism.cases[static_cast<std::size_t>(plan.which)];
  const auto refuse = [&](std::string_view what, std::string_view why, std::string hint) {
    found.error(
        "E0303",
        which.where,
        fmt::format("'motion' reports {}, but case '{}' {}", what, printable(which.label), why),
        std::move(hint));
    return false;
  };
  if (needs_ends && !has_ratio_ends(which)) {
    MissingEnds missing = missing_ratio_ends(mechanism, which);
    return refuse("what passes from input to output", missing.what, std::move(missing.hint));
  }
  if (report.efficiency && !which.names_both_ends()) {
    return refuse("the efficiency",
                  "does not name both ends",
                  "add input: NAME and output: NAME, actuators or loads of the case");
  }
  if ((report.velocity || report.acceleration) && which.motions.empty() && !plan.schedule) {
    return refuse(
        "velocities", "lacks 'motion'", "add motion: {DRIVE: SPEED}, the speed of the drive");
  }
  if (report.dynamics && !which.has_inertia()) {
    return refuse(
        "the effects of inertia",
        "lacks 'acceleration'",
        "add acceleration: {}, or acceleration: {DRIVE: NUMBER} of a drive that speeds up; or "
        "report something else, --report position");
  }
  if (needs_action && !which.asks_actions) {
    return refuse(
        "actions", "lacks 'action'", "add action: {NAME: VALUE}, what is known of the actions");
  }
  return true;
}

}  // namespace kinestat
