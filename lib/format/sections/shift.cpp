// The section `shift`.
#include "format/alternatives.hpp"
#include "format/collections.hpp"
#include "format/number_forms.hpp"
#include "format/sections/input_values.hpp"
#include "format/sections/sections.hpp"
#include "format/value_forms.hpp"

namespace kinestat {

namespace {

const Mapping<ShiftLimitsDescription>& limits_mapping() {
  static const Mapping<ShiftLimitsDescription> mapping(
      "shift_limits",
      "The largest sizes that the gears may have; one that is exceeded is warned of.",
      "{torque: {C1: 200 N*m, B1: 350 N*m}, slip: 4000 rpm, planet_speed: 6000 rpm}",
      [](auto& m) {
        m.key(
             "torque",
             "Of engaged elements, for all or by name; default unit N*m. With losses of meshes the "
             "larger of both torques counts.")
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
              "Of bodies as seen from the ground, by name, or for all that are no planets; default "
              "unit rad/s.")
            .may(&ShiftLimitsDescription::speed,
                 values_for("bodies to values", speed_limit()),
                 "{ring: 6000 rpm}")
            .example("6000 rpm");
        m.key("planet_speed",
              "Of planets as seen from their carrier, which is what their bearings turn with, for "
              "all or by name; default unit rad/s.")
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
      "A change in which one element slips at a steady torque, with the inertia of the bodies.",
      "{from: M1, to: M2, input_speed: 400 rad/s, input_action: 150 N*m, output_action: -250 N*m, "
      "capacity: {B1: 120 N*m}}",
      [](auto& m) {
        m.key("from",
              "The gear before, all of whose elements but one stay engaged. Without it the "
              "transmission is open, and 'output_speed' says how the output turns.")
            .may(&SlipDescription::from, label(), "M1");
        m.key("to", "The gear to which it leads.").needed(&SlipDescription::to, label(), "M2");
        m.key("input_speed", "Speed of the input where the slip begins; default unit rad/s.")
            .needed(&SlipDescription::input_speed, any_number(), "400 rad/s");
        m.key("output_speed", "Speed of the output there, instead of 'from'; default unit rad/s.")
            .may(&SlipDescription::output_speed, any_number(), "0 rad/s");
        m.key("input_action", "Torque of the input all along, 0 of a shaft that runs free.")
            .needed(&SlipDescription::input_action, action(), "150 N*m");
        m.key("output_action",
              "Torque of the output all along: against its speed, what resists the vehicle.")
            .needed(&SlipDescription::output_action, action(), "-250 N*m");
        m.key("capacity",
              "Torque of the element that slips, a size, which may be named: {B1: 120 N*m}; "
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
        m.key("input", "The actuator, or several, that drives.")
            .needed(&ShiftDescription::inputs, one_or_more(name_of("an actuator"), 1), "in");
        m.key("output", "The actuator, or several, that is driven.")
            .needed(&ShiftDescription::outputs, one_or_more(name_of("an actuator"), 1), "out");
        m.key("elements", "The clutches and brakes that shift.")
            .needed(&ShiftDescription::elements,
                    one_or_more(name_of("a clutch or brake"), 1),
                    "[C1, C2, B1, B2]")
            .add_hint("'elements: [C1, C2, B1]', the clutches and brakes");
        m.key(
             "reacts",
             "Machines that bear what equilibrium asks of them, as the generator of a power split. "
             "Then every input has its torque, 0 where 'input_action' gives none, and gears in "
             "which the speeds of inputs follow from each other stand in the same table.")
            .may(&ShiftDescription::reacts, one_or_more(name_of("an actuator"), 1), "MG1");
        m.key("input_motion", "Speed of the input, for every input or by name; default unit rad/s.")
            .may(&ShiftDescription::input_motion, input_values(input_speed()), "1 rad/s")
            .example("{in: 1 rad/s}");
        m.key("input_acceleration",
              "How fast the input speeds up, beside its 'input_action': the gears have the forces "
              "of inertia of their bodies then; default unit rad/s^2.")
            .may(
                &ShiftDescription::input_acceleration, input_values(speed_change()), "200 rad/s^2");
        m.key("input_action", "Torque of the input, for every input or by name; default unit N*m.")
            .may(&ShiftDescription::input_action, input_values(input_load()), "100 N*m")
            .example("{in: 100 N*m}");
        m.key("names",
              "Labels of gears: which elements are engaged. Combinations without a label are named "
              "by their elements, C1+B2.")
            .may(&ShiftDescription::names, gear_labels(), "{M1: [C1, B2]}");
        m.key("slip", "Changes whose slip is followed in time, by names of yours.")
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
              "The sign of the ratios of forward gears; default that which most gears have. It "
              "tells which gears follow each other by steps.")
            .may(&ShiftDescription::forward,
                 choice_of<ForwardRatios>(
                     {{"positive", "the output turns as the input"},
                      {"negative", "it turns against the input, as behind one pair of gears"}}),
                 "negative");
        m.key("combinations", "Which combinations of elements are tried.")
            .may(&ShiftDescription::combinations,
                 choice_of<ShiftCombinations>(
                     {{"all", "all of the size that a gear needs, and those with a label"},
                      {"named", "those of 'names' alone, as of a gearbox whose gears are known"}}),
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
