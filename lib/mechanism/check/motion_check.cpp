#include <algorithm>

#include <fmt/format.h>

#include "core/text.hpp"
#include "mechanism/check/report_name_check.hpp"
#include "mechanism/check/section_checks.hpp"
#include "mechanism/motion_plan.hpp"

namespace kinestat {

namespace {

constexpr NumberRule kRamp = {.kind = QuantityKind::dimensionless,
                              .range = kAboveZero,
                              .allowed = "a number above 0 and at most 0.5"};

std::optional<double> position(const std::optional<Value>& value,
                               DriveKind kind,
                               const SectionContext& context) {
  if (!value) {
    return 0.0;
  }
  switch (kind) {
    case DriveKind::turning:
      return context.evaluator.number(*value, QuantityKind::angle);
    case DriveKind::sliding:
      return context.evaluator.number(*value, QuantityKind::length);
    case DriveKind::unknown:
      context.evaluator.quantity(*value);
      return std::nullopt;
  }
  return std::nullopt;
}

void check_ramp(const std::optional<Value>& ramp,
                std::optional<DriveLaw> law,
                std::string_view what,
                const SectionContext& context) {
  const std::optional<double> share =
      context.number(ramp, kRamp, fmt::format("'ramp' of {}", what));
  if (ramp && law != DriveLaw::trapezoid) {
    context.found.error("E0305",
                        ramp->where,
                        "'ramp' is of law trapezoid alone",
                        "write law: trapezoid, or remove 'ramp'");
  } else if (share && *share > 0.5) {
    context.found.error("E0305",
                        ramp->where,
                        fmt::format("'ramp' of {} is more than half of the time", what),
                        "write a number above 0 and at most 0.5");
  }
}

// Answers whether it moves.
bool check_profile(const DriveRange& range, DriveKind kind, const SectionContext& context) {
  bool moves = false;
  std::optional<double> place = position(range.from, kind, context);
  for (const ProfilePart& part : range.profile) {
    const std::string what = fmt::format("a part of drive '{}'", range.actuator.text);
    context.number(part.time, kDuration, fmt::format("'time' of {}", what));
    context.number(part.dwell, kDuration, fmt::format("'dwell' of {}", what));
    check_ramp(part.ramp, part.law, what, context);
    if (part.to) {
      const std::optional<double> to = position(part.to, kind, context);
      moves = moves || !place || !to || *place != *to;
      place = to;
    }
  }
  return moves;
}

void refuse_curve(const DriveRange& range,
                  std::string_view why,
                  std::string hint,
                  const SectionContext& context) {
  context.found.error(
      "E0305",
      range.curve->where,
      fmt::format(
          "drive '{}' cannot follow curve '{}', {}", range.actuator.text, range.curve->text, why),
      std::move(hint));
}

// What it says is checked with the section `curves`.
void check_curve_of_drive(const DriveRange& range, DriveKind kind, const SectionContext& context) {
  const std::vector<CurveDescription>& curves = context.description.curves;
  const auto curve = std::ranges::find(
      curves, range.curve->text, [](const CurveDescription& one) { return one.name.text; });
  if (curve == curves.end()) {
    std::vector<std::string> names;
    for (const CurveDescription& one : curves) {
      names.push_back(one.name.text);
    }
    context.found.error(
        "E0313",
        range.curve->where,
        fmt::format("no curve is called '{}'", range.curve->text),
        names.empty() ? "add it to a section 'curves:'"
                      : guess_before(range.curve->text, names, "curves are " + plain_list(names)));
    return;
  }
  if (curve->over.text != kTimeWord) {
    refuse_curve(range,
                 fmt::format("which is over '{}'", curve->over.text),
                 "a drive follows a curve with over: time",
                 context);
  } else if (curve->between != CurveCourse::cubic) {
    refuse_curve(range,
                 "whose speed or acceleration jumps at its points",
                 "write between: cubic for this curve, and ends: rest where the drive begins and "
                 "ends at rest",
                 context);
  }
  Diagnostics said_there;
  const auto value =
      curve->points.empty()
          ? std::nullopt
          : context.evaluator.complaining_to(said_there).quantity(curve->points.front().value);
  const QuantityKind wanted =
      kind == DriveKind::sliding ? QuantityKind::length : QuantityKind::angle;
  if (kind != DriveKind::unknown && value && !is_bare(value->dimension) &&
      !fits(value->dimension, wanted)) {
    context.found.error("E0309",
                        range.curve->where,
                        fmt::format("curve '{}' has values of {}, and drive '{}' runs through {}",
                                    range.curve->text,
                                    phrase_of(value->dimension),
                                    range.actuator.text,
                                    phrase_of(wanted)),
                        fmt::format("write values such as {}", example_of(wanted)));
  }
}

// The first of several drives must move; others may hold still. Answers whether it moves.
bool check_range(const DriveRange& range, bool must_move, const SectionContext& context) {
  context.names.check_actuator(range.actuator, "'motion' drives", context.found);
  const DriveKind kind = context.names.kind_of_actuator(range.actuator.text);
  if (limit_sense(range.from, context.description) != 0) {
    context.found.error("E0305",
                        range.from->where,
                        fmt::format("drive '{}' cannot begin at a limit", range.actuator.text),
                        "let it run there: to: limit, or backwards, to: -limit");
    return true;
  }
  if (range.curve) {
    check_curve_of_drive(range, kind, context);
    return true;
  }
  if (!range.profile.empty()) {
    const bool moves = check_profile(range, kind, context);
    if (must_move && !moves) {
      context.found.error("E0509",
                          range.profile.front().where,
                          fmt::format("drive '{}' dwells all along", range.actuator.text),
                          "add a part that moves, {to: 90 deg, time: 0.3 s}; list a drive at rest "
                          "after one that moves");
    }
    return moves;
  }
  const std::optional<double> from = position(range.from, kind, context);
  if (limit_sense(range.to, context.description) != 0) {
    return true;
  }
  const std::optional<double> to = position(range.to, kind, context);
  if (must_move && range.to && from && to && *from == *to) {
    context.found.error("E0305",
                        range.to->where,
                        fmt::format("drive '{}' ends where it begins", range.actuator.text),
                        "give 'to' another value than 'from'; a full turn is to: 360 deg; list a "
                        "drive at rest after one that moves");
  }
  return !from || !to || *from != *to;
}

// How far others would run until one comes to its limit, nobody knows before.
void check_runs_alone(const DriveRange& moving, const SectionContext& context) {
  const MotionDescription& motion = *context.description.motion;
  const auto until_limit = std::ranges::find_if(motion.drives, [&](const DriveRange& one) {
    return limit_sense(one.to, context.description) != 0;
  });
  if (until_limit != motion.drives.end()) {
    context.found.error("E0305",
                        until_limit->to->where,
                        fmt::format("drive '{}' runs to a limit, and '{}' moves too",
                                    until_limit->actuator.text,
                                    moving.actuator.text),
                        "keep all others at rest, with 'from' equal to 'to'");
  }
}

// A name of a point is that of its columns, which those of bodies, couplings and actuators are too.
void check_trace(const std::vector<TracePoint>& trace, const SectionContext& context) {
  const DeclaredNames& names = context.names;
  std::vector<Name> given;
  for (const TracePoint& point : trace) {
    names.bodies.check(point.body, "'trace' of 'motion' follows", context.found);
    context.point(point.at);
    if (!point.name) {
      continue;
    }
    given.push_back(*point.name);
    const std::string_view other = names.bodies.contains(point.name->text)      ? "a body"
                                   : names.couplings.contains(point.name->text) ? "a coupling"
                                   : names.actuators.contains(point.name->text) ? "an actuator"
                                                                                : "";
    if (!other.empty()) {
      context.found.error("E0307",
                          point.name->where,
                          fmt::format("'{}' is the name of {} too", point.name->text, other),
                          "give the point another one");
    }
  }
  context.repeats(given, "'trace' of 'motion'");
}

}  // namespace

void check_motion(const SectionContext& context) {
  if (!context.description.motion) {
    return;
  }
  const MotionDescription& motion = *context.description.motion;
  std::vector<Name> drives;
  const DriveRange* second = nullptr;  // that moves
  for (const DriveRange& range : motion.drives) {
    const bool moves = check_range(range, drives.empty(), context);
    second = moves && !drives.empty() ? &range : second;
    drives.push_back(range.actuator);
  }
  if (second != nullptr) {
    check_runs_alone(*second, context);
  }
  context.repeats(drives, "'drives' of 'motion'");
  context.number(motion.steps, kStepCount, "'steps' of 'motion'");
  context.number(motion.time, kDuration, "'time' of 'motion'");
  check_ramp(motion.ramp, motion.law, "'motion'", context);
  if (motion.label) {
    context.names.cases.check(*motion.label, "'motion' takes its speeds from", context.found);
  }
  check_trace(motion.trace, context);
  check_report_names(motion.report, motion_report_words(), "motion", context);
}

}  // namespace kinestat
