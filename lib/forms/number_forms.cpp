#include "forms/number_forms.hpp"

#include <utility>

#include <fmt/format.h>

#include "forms/value_forms.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

Form<Value> number_form(std::string_view definition,
                        std::string_view meaning,
                        SharedList<std::string_view> examples,
                        NumberRange range) {
  return {.shape = {.kind = FormKind::number,
                    .definition = definition,
                    .meaning = meaning,
                    .examples = std::move(examples),
                    .range = range},
          .read = [](const FileValue& v) { return read_value(v.node, v.what, v.found); },
          .write = [](const Value& value) { return expression_text(value.expression.text()); }};
}

Form<double> plain_number(const Form<Value>& number) {
  return {.shape = number.shape,
          .read = [](const FileValue& v) { return read_number(v.node, v.what, v.found); },
          .write = [](double value) { return single_text(fmt::format("{}", value)); }};
}

Form<std::vector<Value>> couple() {
  return {.shape = {.kind = FormKind::couple, .items = {moment().shape}},
          .read = [](const FileValue& value) -> std::optional<std::vector<Value>> {
            const YamlNode& node = value.node;
            if (value.space == Space::spatial) {
              auto vector = read_point(node, value.what, Space::spatial, value.found);
              return vector ? std::optional(std::move(vector->coordinates)) : std::nullopt;
            }
            if (node.kind == YamlKind::sequence) {
              value.found.error("E0304",
                                node.where,
                                fmt::format("{} is one number about z in planar space", value.what),
                                "write for example couple: 5 N*m");
              return std::nullopt;
            }
            auto one = read_value(node, value.what, value.found);
            return one ? std::optional(std::vector<Value>{*std::move(one)}) : std::nullopt;
          },
          .write =
              [](const std::vector<Value>& values) {
                return values.size() == 1 ? expression_text(values.front().expression.text())
                                          : text_of(values);
              }};
}

Form<Value> bare_number() {
  return number_form("number",
                     "A number without a unit, or an expression of such numbers and parameters.",
                     {"0.1", "1/3", "2*eta"});
}

Form<Value> teeth() {
  return number_form(
      "teeth", "Number of teeth, a whole number from 1 to 10000.", {"19", "N1 + 2*N2"}, kTeeth);
}

Form<Value> planet_count() {
  return number_form(
      "planets", "Number of equal planets, a whole number from 1 to 64.", {"3"}, kPlanets);
}

Form<Value> step_count() {
  return number_form("steps", "A whole number from 1 to 1000000.", {"360"}, kSteps);
}

Form<Value> point_count() {
  return number_form("points", "A whole number from 2 to 1000000.", {"400"}, kPoints);
}

Form<Value> state_count() {
  return number_form("states", "A whole number from 1 to 1e12.", {"100000"}, kStates);
}

Form<Value> seed() {
  return number_form("seed", "A whole number from 0 to 4294967295.", {"1"}, kSeed);
}

Form<Value> digit_count() {
  return number_form("digits", "A whole number from 17 to 100.", {"40"}, kDigits);
}

Form<Value> at_least_one() {
  return number_form(
      "at_least_one", "A number of at least 1, without a unit.", {"12"}, kAtLeastOne);
}

Form<Value> not_zero() {
  return number_form("not_zero", "A number other than 0, without a unit.", {"0.58"}, kNotZero);
}

Form<Value> not_negative() {
  return number_form(
      "not_negative", "A number of at least 0, without a unit.", {"0.1"}, kNotNegative);
}

Form<Value> above_zero() {
  return number_form("above_zero", "A number above 0, without a unit.", {"6.6"}, kAboveZero);
}

Form<Value> duration() {
  return number_form("duration",
                     "A time above 0: a bare number is in the file's unit of time (default s); "
                     "otherwise write the unit.",
                     {"20", "5 min"},
                     kAboveZero);
}

Form<Value> not_negative_whole() {
  return number_form("not_negative_whole",
                     "A whole number of at least 0, without a unit.",
                     {"2"},
                     kNotNegativeWhole);
}

Form<Value> fraction() {
  return number_form("fraction", "A fraction from 0 to below 1.", {"0.02"}, kLostShare);
}

Form<Value> efficiency() {
  return number_form("efficiency", "A fraction above 0 and at most 1.", {"0.98"}, kKeptShare);
}

Form<Value> component() {
  return number_form("component",
                     "Component of a direction: all are numbers without a unit, or all of one "
                     "dimension, such as differences of coordinates.",
                     {"1", "0.5"});
}

Form<Value> length() {
  return number_form("length",
                     "A length: a bare number is in the file's unit of length (default m); "
                     "otherwise write the unit.",
                     {"7", "25 mm", "(N1 + N5)/2*module"});
}

Form<Value> size() {
  return number_form(
      "size",
      "A length above zero: a bare number is in the file's unit of length (default m); otherwise "
      "write the unit.",
      {"25 mm"},
      kAboveZero);
}

Form<Value> non_negative_length() {
  return number_form("non_negative_length",
                     "A length of at least zero: a bare number is in the file's unit of length "
                     "(default m); otherwise write the unit.",
                     {"12 mm"},
                     kNotNegative);
}

Form<Value> pitch() {
  return number_form("pitch",
                     "A pitch, the length per radian: a bare number is in the file's unit of "
                     "length per radian; otherwise write the unit.",
                     {"2 mm/rad", "5 mm/rev", "0.8"});
}

Form<Value> lead() {
  return number_form("lead",
                     "A lead, the length per turn: a bare number is in the file's unit of length; "
                     "otherwise write the unit.",
                     {"5 mm", "5 mm/rev", "5"});
}

Form<Value> stiffness() {
  return number_form(
      "stiffness",
      "Stiffness of a constraint, which must be positive. Of a force it is a force per length: a "
      "bare number is in the file's unit of stiffness (default N/m). Of a couple it is a moment "
      "per angle: a bare number is in the file's unit of moment per rad (default N*m/rad), "
      "whatever the unit of stiffness or of angle is.",
      {"2e6 N/m", "300 N*m/rad"},
      kAboveZero);
}

Form<Value> friction_moment() {
  return number_form("friction_moment",
                     "A moment of at least zero: a bare number is in the file's unit of moment "
                     "(default N*m); otherwise write the unit.",
                     {"0.2 N*m"},
                     kNotNegative);
}

Form<Value> viscous_couple() {
  return number_form("viscous_couple",
                     "A couple per angular velocity: a bare number is in the file's unit of moment "
                     "per its unit of angular velocity (default N*m*s/rad).",
                     {"0.02", "0.02 N*m*s/rad"},
                     kNotNegative);
}

Form<Value> viscous_force() {
  return number_form("viscous_force",
                     "A force per velocity: a bare number is in the file's unit of force per its "
                     "unit of velocity (default N*s/m).",
                     {"5", "5 N*s/m"},
                     kNotNegative);
}

Form<Value> acute_angle() {
  return number_form("acute_angle",
                     "An angle from 0 to below 90 deg: a bare number is in the file's unit of "
                     "angle (default rad); otherwise write the unit.",
                     {"20 deg"},
                     in_any_unit(kAcuteAngle));
}

Form<Value> angle() {
  return number_form("angle",
                     "An angle: a bare number is in the file's unit of angle (default rad); "
                     "otherwise write the unit.",
                     {"20 deg", "pi/9 rad", "alpha"});
}

Form<Value> mass() {
  return number_form("mass",
                     "A mass of at least zero: a bare number is in the file's unit of mass "
                     "(default kg); otherwise write the unit.",
                     {"2.5", "500 g"},
                     kNotNegative);
}

Form<Value> moment_of_inertia() {
  return number_form("moment_of_inertia",
                     "A moment of inertia of at least zero: a bare number is in the file's unit of "
                     "inertia (default kg*m^2); otherwise write the unit.",
                     {"0.002", "2000 kg*mm^2"},
                     kNotNegative);
}

Form<Value> product_of_inertia() {
  return number_form("inertia_entry",
                     "An entry of a tensor of inertia: a bare number is in the file's unit of "
                     "inertia (default kg*m^2); otherwise write the unit.",
                     {"-0.0001", "-100 kg*mm^2"});
}

Form<Value> force() {
  return number_form(
      "force",
      "A force: a bare number is in the file's unit of force (default N); otherwise write the "
      "unit.",
      {"100", "1.5 kN", "-F_load"});
}

Form<Value> moment() {
  return number_form(
      "moment",
      "A moment or torque: a bare number is in the file's unit of moment (default N*m); otherwise "
      "write the unit.",
      {"100", "5000 N*mm", "T_in"});
}

Form<Value> acceleration() {
  return number_form(
      "acceleration",
      "An acceleration: a bare number is in the file's unit of length per its unit of time squared "
      "(default m/s^2); otherwise write the unit.",
      {"-9.81", "9.81 m/s^2", "0"});
}

Form<Value> speed() {
  return number_form(
      "speed",
      "Rate of a freedom of the head relative to the tail: angular velocity (default "
      "rad/s) of a rotation, velocity (default m/s) of a translation. 0 holds it.",
      {"1 rad/s", "1500 rpm", "0.2 m/s", "0"});
}

Form<Value> speed_change() {
  return number_form(
      "acceleration_of_freedom",
      "Rate of change of the speed of a freedom: angular acceleration (rad/s^2) of a rotation, "
      "acceleration (default m/s^2) of a translation. 0 keeps the speed constant.",
      {"0", "50 rad/s^2", "1.2 m/s^2"});
}

Form<Value> drawn_position() {
  return number_form(
      "drawn_position",
      "Position of a freedom, measured from the drawn position: an angle or a length, a"
      " bare number in the file's unit.",
      {"0 deg", "360 deg", "-20 mm"});
}

Form<Value> increment() {
  return number_form("step",
                     "A number other than 0, with the units of the parameter.",
                     {"1", "2.5 deg"},
                     kNotZero);
}

Form<Value> input_speed() {
  return number_form(
      "input_speed",
      "Speed of an input, not 0: angular velocity (default rad/s) or velocity (default "
      "m/s).",
      {"1 rad/s"},
      kNotZero);
}

Form<Value> input_load() {
  return number_form("input_load",
                     "Torque (default N*m) or force (default N) of an input, not 0.",
                     {"100 N*m"},
                     kNotZero);
}

Form<Value> torque_limit() {
  return number_form("torque_limit", "A torque above zero (default N*m).", {"200 N*m"}, kAboveZero);
}

Form<Value> speed_limit() {
  return number_form(
      "speed_limit", "An angular velocity above zero (default rad/s).", {"6000 rpm"}, kAboveZero);
}

Form<Value> any_number() {
  return number_form("value",
                     "A number with or without a unit, or an expression of other parameters.",
                     {"19", "20 deg", "(N1 + N5)/2*module", "3 mm + 2 cm"});
}

Form<Value> action() {
  return number_form("load",
                     "Action of the tail on the head: couple (default N*m) or force (default N). 0 "
                     "means that nothing acts.",
                     {"1 N*m", "-250 N", "T_in", "0"});
}

}  // namespace kinestat
