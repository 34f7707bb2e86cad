// The section `motion`.
#include <fmt/format.h>

#include "format/sections/sections.hpp"
#include "forms/number_forms.hpp"
#include "forms/value_forms.hpp"

namespace kinestat {

namespace {

constexpr const char* kDrivesHint =
    "write drives: [{drive: NAME, from: 0 deg, to: 90 deg}, …], or drive, from and to for one";

Form<DriveLaw> drive_law() {
  return choice_of<DriveLaw>(
      {{"constant_speed", "speed jumps at both ends"},
       {"constant_acceleration", "accelerates for half of the time"},
       {"trapezoid",
        "accelerates for the fraction 'ramp' of the time, then runs at constant speed"},
       {"polynomial_345", "acceleration starts and ends at zero"},
       {"polynomial_4567", "jerk starts and ends at zero too"},
       {"cycloidal", "sinusoidal acceleration"},
       {"harmonic", "cosine acceleration"},
       {"modified_trapezoid", "smallest peak acceleration of the smooth laws"},
       {"modified_sine", "smallest peak torque of the smooth laws"}});
}

const Mapping<ProfilePart>& profile_part() {
  static const Mapping<ProfilePart> mapping(
      "profile_part",
      "One part of the motion of a drive: to a position by a law, or a dwell.",
      "{to: 90 deg, time: 0.3 s, law: polynomial_345}",
      [](auto& m) {
        m.key("to", "Where it ends, measured from the drawn position.")
            .may(&ProfilePart::to, drawn_position(), "90 deg");
        m.key("time", "The duration of this part.").may(&ProfilePart::time, duration(), "0.3 s");
        m.key("law", "The law of motion, from rest to rest.")
            .may(&ProfilePart::law, drive_law(), "polynomial_345")
            .usual("polynomial_345");
        m.key("ramp",
              "For law trapezoid: the fraction of the time spent accelerating, above 0 up to 1/2.")
            .may(&ProfilePart::ramp, above_zero(), "1/3")
            .usual("1/3");
        m.key("dwell", "Instead of these: how long it rests where it is.")
            .may(&ProfilePart::dwell, duration(), "0.2 s");
        m.rule({.kind = FormRule::Kind::one_of,
                .others = {"to", "dwell"},
                .message = "{} needs one of 'to' and 'dwell'",
                .hint = "write {to: 90 deg, time: 0.3 s, law: polynomial_345}, or {dwell: 0.2 s}"});
        m.rule({.kind = FormRule::Kind::together,
                .key = "to",
                .others = {"time"},
                .message = "{} has a place but no time",
                .hint = "add how long it takes to get there, for example time: 0.3 s"});
        m.rule({.kind = FormRule::Kind::excludes,
                .key = "dwell",
                .others = {"time", "law", "ramp"},
                .message = "{} dwells, and has 'time', 'law' or 'ramp' too",
                .hint = "write {dwell: 0.2 s} alone"});
      });
  return mapping;
}

void declare_drive(Mapping<DriveRange>& m) {
  m.key("drive", "The driving actuator.")
      .needed(&DriveRange::actuator, name_of("an actuator"), "drive");
  m.key("from", "Where the motion starts, measured from the drawn position.")
      .may(&DriveRange::from, drawn_position(), "0 deg")
      .usual("0");
}

void declare_course(Mapping<DriveRange>& m) {
  m.key("profile",
        "Instead of 'to': how it runs in time, part by part; after the last part it rests.")
      .may(&DriveRange::profile,
           list_of(profile_part().form(), "part {0} of {1}"),
           "[{to: 90 deg, time: 0.3 s, law: cycloidal}, {dwell: 0.2 s}]");
  m.key("curve",
        "Instead of 'to': the curve over time that it follows, with between: cubic; 'from' is its "
        "value at 0.")
      .may(&DriveRange::curve, name_of("a curve over time"), "feed");
}

// Of the mapping in which the keys of a drive stand.
template <class T>
void declare_course_rules(Mapping<T>& m) {
  m.rule({.kind = FormRule::Kind::excludes,
          .key = "profile",
          .others = {"to", "curve"},
          .message = "{} has 'profile', and 'to' or 'curve' too",
          .hint = "keep one of 'to', 'profile' and 'curve'"});
  m.rule({.kind = FormRule::Kind::excludes,
          .key = "curve",
          .others = {"to", "from"},
          .message = "{} has 'curve', and 'from' or 'to' too",
          .hint = "the curve says where the drive is at any time: remove the other"});
}

const Mapping<DriveRange>& drive_range() {
  static const Mapping<DriveRange> mapping("drive_range",
                                           "A drive and the range it runs through.",
                                           "{drive: drive, from: 0 deg, to: 360 deg}",
                                           [](auto& m) {
                                             declare_drive(m);
                                             m.key("to",
                                                   "Where the motion ends, measured from the drawn "
                                                   "position; limit: where the drive reverses, "
                                                   "-limit: the same in the other direction.")
                                                 .needed(
                                                     &DriveRange::to, drawn_position(), "360 deg");
                                             declare_course(m);
                                           });
  return mapping;
}

// Of several drives; what they need beside each other is checked once all is read.
const Mapping<DriveRange>& one_of_several() {
  static const Mapping<DriveRange> mapping(
      "one_drive_range",
      "One of several drives and the range it runs through.",
      "{drive: drive, from: 0 deg, to: 360 deg}",
      [](auto& m) {
        declare_drive(m);
        m.key("to",
              "Where the motion ends, measured from the drawn position; with 'time' and without a "
              "law it follows from the speed.")
            .may(&DriveRange::to, drawn_position(), "360 deg");
        declare_course(m);
        declare_course_rules(m);
      });
  return mapping;
}

void check_drive_ends(const MotionDescription& motion, const FileValue& value) {
  for (std::size_t d = 0; d < motion.drives.size() && !motion.time; ++d) {
    if (!motion.drives[d].to && !motion.drives[d].has_course()) {
      value.found.error("E0303",
                        motion.drives[d].where,
                        fmt::format("drive {} of 'motion' lacks the key 'to'", d + 1),
                        "add for example 'to: 360 deg'");
    }
  }
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
        m.key("name", "Its name in the report; default: BODY.N, the N-th of all.")
            .may(&TracePoint::name, new_name("a traced point"), "pen");
      });
  return mapping;
}

void declare_report(Mapping<MotionDescription>& m) {
  m.key("report",
        "What each step reports: position, velocity, acceleration, action, reaction, power, "
        "efficiency, ratio, transmission_angle, mechanical_advantage, dynamics, an actuator, "
        "a coupling for all its actions, COUPLING.FREEDOM and COUPLING.ACTION, or columns by their "
        "names, NAME/QUANTITY.")
      .may(&MotionDescription::report, one_or_more(column_name()), "[velocity, d.wz]")
      .offer("position", "positions of the freedoms")
      .offer("velocity", "velocities of the freedoms")
      .offer("acceleration", "accelerations of the freedoms")
      .offer("action", "the actions of the couplings")
      .offer("reaction", "resultant forces of the couplings, with friction and its loss")
      .offer("power", "the powers of the couplings")
      .offer("efficiency", "power of the outputs over that of the inputs of the case")
      .offer("ratio", "input speed over output speed")
      .offer("transmission_angle", "the angle that tells how well the force drives the output")
      .offer("mechanical_advantage", "action of the output over that of the input")
      .offer("dynamics", "energy, shaking and ground forces, equivalent inertia");
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
            kDrivesHint,
            &one_of_several());
        m.check(check_drive_ends);
        m.key("steps", "Number of steps between start and end.")
            .may(&MotionDescription::steps, step_count(), "360")
            .usual(usual_number<kUsualSteps>());
        m.key("time",
              "Duration of the whole motion; steps are then equal in time. Without a 'law' the "
              "drives run with the speed and acceleration of the case, and 'to' may be left out.")
            .may(&MotionDescription::time, duration(), "0.5 s");
        m.key("law", "The law of motion of all drives, from rest to rest in that time.")
            .may(&MotionDescription::law, drive_law(), "polynomial_345");
        m.key("ramp",
              "For law trapezoid: the fraction of the time spent accelerating, above 0 up to 1/2.")
            .may(&MotionDescription::ramp, above_zero(), "1/3")
            .usual("1/3");
        declare_course_rules(m);
        for (const std::string_view course : {"time", "profile", "curve"}) {
          m.rule({.kind = FormRule::Kind::spares, .key = course, .others = {"to"}});
        }
        m.rule({.kind = FormRule::Kind::together,
                .key = "law",
                .others = {"time"},
                .message = "{} has a law but no time",
                .hint = "add how long it takes, for example time: 0.5 s"});
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
