// The section `duty`.
#include <string>
#include <utility>

#include "format/sections/input_values.hpp"
#include "format/sections/sections.hpp"
#include "forms/alternatives.hpp"
#include "forms/collections.hpp"
#include "forms/number_forms.hpp"
#include "forms/value_forms.hpp"

namespace kinestat {

namespace {

Form<Name> path() {
  return converted<Name>(
      called(text(), "the table of points"),
      [](std::string one) { return Name{.text = std::move(one), .where = {}}; },
      [](const Name& one) { return one.text; });
}

const Mapping<DutyPointDescription>& point_mapping() {
  static const Mapping<DutyPointDescription> mapping(
      "duty_point",
      "A case for some time, with its own known magnitudes of the inputs.",
      "{case: M1, input_motion: 1500 rpm, input_action: 80 N*m, duration: 20 s}",
      [](auto& m) {
        m.key("case", "The case, or the gear of 'shift'; default: that of the section.")
            .may(&DutyPointDescription::case_label, label(), "M1");
        m.key("input_motion",
              "Speed of the input, for every input or by name; default: that of the case.")
            .may(&DutyPointDescription::input_motion, input_values(input_speed()), "1500 rpm")
            .example("{engine: 1500 rpm}");
        m.key("input_action",
              "Torque of the input, for every input or by name; default: that of the case.")
            .may(&DutyPointDescription::input_action, input_values(action()), "80 N*m")
            .example("{engine: 80 N*m}");
        m.key("duration", "Duration.").needed(&DutyPointDescription::duration, duration(), "20 s");
      });
  return mapping;
}

}  // namespace

const Mapping<DutyDescription>& duty_section() {
  static const Mapping<DutyDescription> mapping(
      "",
      "",
      "{points: [{case: M1, input_motion: 1500 rpm, input_action: 80 N*m, duration: 20 s}]}",
      [](auto& m) {
        m.key("points", "The points of the cycle, in order.")
            .may(&DutyDescription::points,
                 list_of(point_mapping().form(),
                         "a point of 'duty'",
                         "write '- {case: M1, duration: 20 s}'"),
                 "[{case: M1, input_motion: 1500 rpm, input_action: 80 N*m, duration: 20 s}]");
        m.key("file",
              "A table of points beside this file, as CSV: columns 'case', 'duration [s]' or 'time "
              "[s]', and actuators with units, 'engine [rpm]', 'engine [N*m]'.")
            .may(&DutyDescription::file, path(), "cycle.csv");
        m.key("case", "The case or gear of points that name none.")
            .may(&DutyDescription::case_label, label(), "M1");
        m.key("repetitions", "How often the sequence of points is repeated.")
            .may(&DutyDescription::repetitions, above_zero(), "10000")
            .usual("1");
        m.key("gear_exponent",
              "Exponent of Miner's rule for teeth, required for equivalent torques: the slope of "
              "their Wöhler (S-N) curve.")
            .may(&DutyDescription::gear_exponent, above_zero(), "6.6");
        m.key("bearing_exponent",
              "Exponent of Miner's rule for bearings, required for equivalent forces: 3 for ball "
              "bearings, 10/3 for roller bearings.")
            .may(&DutyDescription::bearing_exponent, above_zero(), "10/3");
        m.rule({.kind = FormRule::Kind::any_of, .others = {"points", "file"}});
      });
  return mapping;
}

}  // namespace kinestat
