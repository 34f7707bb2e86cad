// The section `motion`.
#include "format/number_forms.hpp"
#include "format/sections/sections.hpp"
#include "format/value_forms.hpp"

namespace kinestat {

namespace {

constexpr const char* kDrivesHint =
    "write drives: [{drive: NAME, from: 0 deg, to: 90 deg}, …], or drive, from and to for one";

const Mapping<DriveRange>& drive_range() {
  static const Mapping<DriveRange> mapping(
      "drive_range",
      "A drive and the range it runs through.",
      "{drive: drive, from: 0 deg, to: 360 deg}",
      [](auto& m) {
        m.key("drive", "The actuator that drives.")
            .needed(&DriveRange::actuator, name_of("an actuator"), "drive");
        m.key("from", "Where the motion begins, measured from the drawn position.")
            .may(&DriveRange::from, drawn_position(), "0 deg")
            .usual("0");
        m.key("to",
              "Where the motion ends, measured from the drawn position; limit: where the drive "
              "turns "
              "back, -limit: where it does so backwards.")
            .needed(&DriveRange::to, drawn_position(), "360 deg");
      });
  return mapping;
}

const Mapping<TracePoint>& trace_point() {
  static const Mapping<TracePoint> mapping(
      "trace_point",
      "A point of a body whose path is reported.",
      "{body: coupler, at: [3, 4]}",
      [](auto& m) {
        m.key("body", "The body that carries the point.")
            .needed(&TracePoint::body, body_name(), "coupler");
        m.key("at", "The point in the drawn position.").needed(&TracePoint::at, point());
        m.key("name", "By which the report calls it; BODY.N, the N-th of all, without one.")
            .may(&TracePoint::name, new_name("a traced point"), "pen");
      });
  return mapping;
}

void declare_report(Mapping<MotionDescription>& m) {
  m.key("report",
        "What each step reports: position, velocity, acceleration, action, power, ratio, "
        "transmission_angle, mechanical_advantage, an actuator, or COUPLING.FREEDOM and "
        "COUPLING.ACTION.")
      .may(&MotionDescription::report, one_or_more(target()), "[velocity, d.wz]")
      .offer("position", "positions of the freedoms")
      .offer("velocity", "velocities of the freedoms")
      .offer("acceleration", "accelerations of the freedoms")
      .offer("action", "the actions of the couplings")
      .offer("power", "the powers of the couplings")
      .offer("ratio", "input speed by output speed")
      .offer("transmission_angle", "how well the force on the output is aimed")
      .offer("mechanical_advantage", "action of the output over that of the input");
}

}  // namespace

const Mapping<MotionDescription>& motion_section() {
  static const Mapping<MotionDescription> mapping(
      "", "", "{drive: drive, from: 0 deg, to: 360 deg, steps: 360}", [](auto& m) {
        m.one_or_several(
            drive_range(),
            &MotionDescription::drives,
            {.key = "drives",
             .meaning = "Several drives, each with its range, instead of 'drive', 'from' and 'to'.",
             .examples = {"[{drive: first, to: 360 deg}, {drive: second, to: 180 deg}]"}},
            "drive {0} of {1}",
            kDrivesHint);
        m.key("steps", "Number of steps between beginning and end.")
            .may(&MotionDescription::steps, step_count(), "360")
            .usual(usual_number<kUsualSteps>());
        m.key("case", "The case whose speeds and loads apply.")
            .may(&MotionDescription::label, label(), "design point");
        m.key("trace", "Points of bodies whose paths are reported.")
            .may(&MotionDescription::trace,
                 list_of(trace_point().form(), "trace point {0}"),
                 "[{body: coupler, at: [3, 4]}]");
        declare_report(m);
      });
  return mapping;
}

}  // namespace kinestat
