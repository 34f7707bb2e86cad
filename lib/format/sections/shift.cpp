// The section `shift`.
#include "format/sections/input_values.hpp"
#include "format/sections/sections.hpp"
#include "forms/alternatives.hpp"
#include "forms/collections.hpp"
#include "forms/number_forms.hpp"
#include "forms/value_forms.hpp"

namespace kinestat {

namespace {

const Mapping<ShiftLimitsDescription>& limits_mapping() {
  static const Mapping<ShiftLimitsDescription> mapping(
      "shift_limits",
      "The largest magnitudes permitted in the gears; exceeding one gives a warning.",
      "{torque: {C1: 200 N*m, B1: 350 N*m}, slip: 4000 rpm, planet_speed: 6000 rpm}",
      [](auto& m) {
        m.key("torque",
              "Of engaged elements, for all or by name; default unit N*m. With mesh losses the "
              "larger of the torques without and with them counts.")
            .may(&ShiftLimitsDescription::torque,
                 values_for("elements to values", torque_limit()),
                 "{C1: 200 N*m, B1: 350 N*m}")
            .example("200 N*m");
        m.key("slip", "Speed of open elements, for all or by name; default unit rad/s.")
            .may(&ShiftLimitsDescription::slip,
                 values_for("elements to values", speed_limit()),
                 "{C1: 4000 rpm}")
            .example("4000 rpm");
        m.key("speed",
              "Of bodies relative to the ground, by name, or for all that are not planets; default "
              "unit rad/s.")
            .may(&ShiftLimitsDescription::speed,
                 values_for("bodies to values", speed_limit()),
                 "{ring: 6000 rpm}")
            .example("6000 rpm");
        m.key("planet_speed",
              "Of planets relative to their carrier, which is the speed of their bearings, for all "
              "or by name; default unit rad/s.")
            .may(&ShiftLimitsDescription::planet_speed,
                 values_for("planets to values", speed_limit()),
                 "{planet: 8000 rpm}")
            .example("8000 rpm");
      });
  return mapping;
}

const Mapping<SlipDescription>& slip_mapping() {
  static const Mapping<SlipDescription> mapping(
      "shift_slip",
      "A gear change in which one element slips at a constant torque, with the inertia of the "
      "bodies.",
      "{from: M1, to: M2, input_speed: 400 rad/s, input_action: 150 N*m, output_action: -250 N*m, "
      "capacity: {B1: 120 N*m}}",
      [](auto& m) {
        m.key("from",
              "The previous gear, all of whose elements but one stay engaged. Without it the "
              "transmission is open, and 'output_speed' gives the speed of the output.")
            .may(&SlipDescription::from, label(), "M1");
        m.key("to", "The gear after the change.").needed(&SlipDescription::to, label(), "M2");
        m.key("input_speed", "Speed of the input where the slip begins; default unit rad/s.")
            .needed(&SlipDescription::input_speed, any_number(), "400 rad/s");
        m.key("output_speed", "Speed of the output there, instead of 'from'; default unit rad/s.")
            .may(&SlipDescription::output_speed, any_number(), "0 rad/s");
        m.key("input_action", "Torque of the input throughout; 0 for a shaft that runs free.")
            .needed(&SlipDescription::input_action, action(), "150 N*m");
        m.key("output_action",
              "Torque of the output throughout: the resistance of the vehicle acts against its "
              "speed.")
            .needed(&SlipDescription::output_action, action(), "-250 N*m");
        m.key("capacity",
              "Torque of the slipping element, a magnitude, which may be named: {B1: 120 N*m}; "
              "default unit N*m.")
            .needed(&SlipDescription::capacity,
                    values_for("elements to values", torque_limit()),
                    "{B1: 120 N*m}")
            .example("120 N*m");
        m.rule({.kind = FormRule::Kind::one_of,
                .others = {"from", "output_speed"},
                .message = "{} needs one of 'from' and 'output_speed'",
                .hint = "write from: GEAR for a change between two gears, or output_speed: 0 rad/s "
                        "where a clutch closes while the transmission is open"});
      });
  return mapping;
}

Form<std::vector<GearLabel>> gear_labels() {
  return values_by_name(&GearLabel::label,
                        &GearLabel::elements,
                        one_or_more(name_of("a clutch or brake")),
                        {.elements = "labels to elements"},
                        "gear '{0}'");
}

}  // namespace

const Mapping<ShiftDescription>& shift_section() {
  static const Mapping<ShiftDescription> mapping(
      "",
      "",
      "{input: in, output: out, elements: [C1, C2, B1, B2], input_motion: 1 rad/s, "
      "input_action: 100 N*m}",
      [](auto& m) {
        m.write_in_lines();
        m.key("input", "The driving actuator, or several.")
            .needed(&ShiftDescription::inputs, one_or_more(name_of("an actuator"), 1), "in");
        m.key("output", "The driven actuator, or several.")
            .needed(&ShiftDescription::outputs, one_or_more(name_of("an actuator"), 1), "out");
        m.key("elements", "The shift elements: clutches and brakes.")
            .needed(&ShiftDescription::elements,
                    one_or_more(name_of("a clutch or brake"), 1),
                    "[C1, C2, B1, B2]")
            .add_hint("'elements: [C1, C2, B1]', the clutches and brakes");
        m.key(
             "reacts",
             "Machines that provide the torque that equilibrium requires, such as the generator of "
             "a power split. Every input then has its torque, 0 unless 'input_action' gives one, "
             "and gears in which input speeds depend on each other are in the same table.")
            .may(&ShiftDescription::reacts, one_or_more(name_of("an actuator"), 1), "MG1");
        m.key("input_motion", "Speed of the input, for every input or by name; default unit rad/s.")
            .may(&ShiftDescription::input_motion, input_values(input_speed()), "1 rad/s")
            .example("{in: 1 rad/s}");
        m.key("input_acceleration",
              "Acceleration of the input, in addition to its 'input_action': gears then include "
              "the inertia forces of their bodies; default unit rad/s^2.")
            .may(
                &ShiftDescription::input_acceleration, input_values(speed_change()), "200 rad/s^2");
        m.key("input_action", "Torque of the input, for every input or by name; default unit N*m.")
            .may(&ShiftDescription::input_action, input_values(input_load()), "100 N*m")
            .example("{in: 100 N*m}");
        m.key("names",
              "Labels of gears: which elements are engaged. Combinations without a label are named "
              "by their elements, C1+B2.")
            .may(&ShiftDescription::names, gear_labels(), "{M1: [C1, B2]}");
        m.key("slip", "Gear changes whose slip is calculated over time, by names of your choice.")
            .may(&ShiftDescription::slips,
                 named(&SlipDescription::name,
                       slip_mapping().form(),
                       {.item = "a slip", .elements = "names to slips"},
                       "slip '{0}'"),
                 "{up: {from: M1, to: M2, input_speed: 400 rad/s, input_action: 150 N*m, "
                 "output_action: -250 N*m, capacity: {B1: 120 N*m}}}");
        m.key("limits", "Torques and speeds that the gears may not exceed.")
            .may(&ShiftDescription::limits,
                 limits_mapping().form(),
                 "{torque: {C1: 200 N*m}, slip: 4000 rpm}");
        m.key("forward",
              "The sign of the ratios of forward gears; default: that of most gears. It determines "
              "which gears are consecutive for steps.")
            .may(&ShiftDescription::forward,
                 choice_of<ForwardRatios>(
                     {{"positive", "the output turns in the same direction as the input"},
                      {"negative", "it turns against the input, as after one pair of gears"}}),
                 "negative");
        m.key("combinations", "Which combinations of elements are tried.")
            .may(&ShiftDescription::combinations,
                 choice_of<ShiftCombinations>(
                     {{"all",
                       "all with the number of elements that a gear needs, and those with a label"},
                      {"named", "only those of 'names', for a gearbox whose gears are known"}}),
                 "named")
            .usual("all");
        m.rule({.kind = FormRule::Kind::together,
                .key = "input_acceleration",
                .others = {"input_action"},
                .message = "'input_acceleration' of {0} needs the key 'input_action'",
                .hint = "add the torque of the input, for example input_action: 100 N*m"});
        m.rule({.kind = FormRule::Kind::together,
                .key = "combinations",
                .others = {"names"},
                .message = "'combinations' of {0} needs the key 'names'",
                .hint = "add the gears, 'names: {M1: [C1, B2]}', or remove 'combinations'"});
      });
  return mapping;
}

}  // namespace kinestat
