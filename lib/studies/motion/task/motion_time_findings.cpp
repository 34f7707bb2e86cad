#include <fmt/format.h>

#include "core/utf8.hpp"
#include "studies/motion/task/motion_findings.hpp"

namespace kinestat {

namespace {

struct TimeText {
  std::string message;
  std::string hint;
};

TimeText text_of(const MotionPlan& plan, const std::string& drive, const std::string& label) {
  switch (plan.time_problem) {
    case TimeProblem::none:
      break;
    case TimeProblem::no_speed:
      return {fmt::format("nothing says how drive '{}' runs in that time", drive),
              fmt::format("give its speed in the case of the motion: motion: {{{}: NUMBER}}, or a "
                          "law: law: polynomial_345",
                          drive)};
    case TimeProblem::two_speeds:
      return {fmt::format("drive '{}' has a speed in case '{}' and a law too", drive, label),
              fmt::format("write motion: {{}} or {}: 0 in the case, or leave out 'law'", drive)};
    case TimeProblem::two_courses:
      return {
          fmt::format(
              "drive '{}' has a speed in case '{}', and a profile or a curve too", drive, label),
          fmt::format("write motion: {{}} or {}: 0 in the case", drive)};
    case TimeProblem::too_long:
      return {fmt::format("the profile of drive '{}' takes longer than 'time'", drive),
              "leave out 'time', which follows from the profile, or shorten its parts"};
    case TimeProblem::beyond_curve:
      return {fmt::format("the curve of drive '{}' does not reach from 0 to the end of the motion",
                          drive),
              "let its first point be at 0 s and its last at 'time', or leave out 'time'"};
    case TimeProblem::no_duration:
      return {fmt::format("the curve of drive '{}' repeats, and nothing says how long the motion "
                          "takes",
                          drive),
              "add 'time' to the motion, for example time: 2 s"};
    case TimeProblem::at_rest:
      return {fmt::format("drive '{}' is at rest", drive), "give it a speed or a law"};
    case TimeProblem::never:
      return {
          fmt::format(
              "drive '{}' never reaches its end with the speed and the acceleration of case '{}'",
              drive,
              label),
          "give 'to' on the side to which it runs, within what it reaches before it turns back, "
          "or 'time' in place of 'to'"};
    case TimeProblem::other_end:
      return {fmt::format("drive '{}' is not at 'to' after that time, with the speed and the "
                          "acceleration of case '{}'",
                          drive,
                          label),
              "leave out 'to' or 'time', or give a law"};
    case TimeProblem::to_limit:
      return {fmt::format("drive '{}' runs to a limit, which nobody knows before in time", drive),
              "leave out 'time', 'law' and what speeds up, or write the place of the "
              "limit, which the report of a motion without them tells"};
    case TimeProblem::other_time:
      return {fmt::format("drive '{}' reaches its end at another time than the first drive", drive),
              "give 'time' in place of 'to', or a law for all"};
  }
  return {};
}

// "at the beginning and after 0.2 s"
std::string places_of(const std::vector<double>& shares,
                      const DriveSchedule& schedule,
                      const FileUnits& units) {
  std::vector<std::string> places;
  for (const double share : shares) {
    places.push_back(
        share == 0.0 ? "at the beginning"
                     : fmt::format("after {:.6g} {}",
                                   units.from_si(QuantityKind::time, share * schedule.duration()),
                                   units.text(QuantityKind::time)));
  }
  constexpr std::size_t kMostPlaces = 4;
  if (places.size() > kMostPlaces) {
    places.resize(kMostPlaces);
    return fmt::format("{}, …", fmt::join(places, ", "));
  }
  const std::string last = places.back();
  places.pop_back();
  return fmt::format("{} and {}", fmt::join(places, ", "), last);
}

}  // namespace

bool check_time(const MotionPlan& plan,
                const Mechanism& mechanism,
                const FileUnits& units,
                Diagnostics& found) {
  const Topology& topology = mechanism.topology;
  const auto name_of = [&](std::size_t d) {
    return topology.actuators[static_cast<std::size_t>(plan.drives[d].actuator)].name;
  };
  if (plan.time_problem != TimeProblem::none) {
    const std::string label =
        plan.which < 0 ? ""
                       : printable(mechanism.cases[static_cast<std::size_t>(plan.which)].label);
    TimeText text = text_of(plan, name_of(plan.problem_drive), label);
    found.error("E0509",
                plan.drives[plan.problem_drive].where,
                std::move(text.message),
                std::move(text.hint));
    return false;
  }
  const std::vector<double> jumps =
      plan.schedule && plan.which >= 0 &&
              mechanism.cases[static_cast<std::size_t>(plan.which)].has_inertia()
          ? plan.schedule->jumps()
          : std::vector<double>();
  if (!jumps.empty()) {
    found.warning("W0512",
                  plan.where,
                  fmt::format("law constant_speed requires infinite accelerations {}",
                              places_of(jumps, *plan.schedule, units)),
                  "values at its ends are those between them; polynomial_345 or cycloidal begin "
                  "and end at rest");
  }
  return true;
}

}  // namespace kinestat
