// The key `characteristic` of a torque converter.
#include "format/sections/coupling_values.hpp"
#include "forms/alternatives.hpp"
#include "forms/collections.hpp"
#include "forms/mapping.hpp"
#include "forms/number_forms.hpp"

namespace kinestat {

namespace {

using Characteristic = CharacteristicDescription;

Form<Value> density() {
  return number_form(
      "density", "A density above 0: a bare number is in kg/m^3.", {"860 kg/m^3"}, kAboveZero);
}

// A table of values, or one expression.
Form<std::vector<Value>> values_of(const Form<Value>& item) {
  auto form = one_or_more(item, 2);
  form.write = [item, write = form.write](const std::vector<Value>& values) {
    return values.size() == 1 ? item.write(values.front()) : write(values);
  };
  return called(std::move(form), "{1}");
}

void add_rules(Mapping<Characteristic>& m) {
  using enum FormRule::Kind;
  m.rule({.kind = one_of,
          .others = {"pump_torque", "lambda"},
          .message = "{} needs one of 'pump_torque' and 'lambda'",
          .hint =
              "write what the pump takes at a speed, pump_torque: 150 N*m with pump_speed: 2000 "
              "rpm, or lambda with density and diameter"});
  const auto need = [&](std::string_view key,
                        std::string_view other,
                        std::string_view message,
                        std::string_view hint) {
    m.rule({.kind = together, .key = key, .others = {other}, .message = message, .hint = hint});
  };
  need("pump_torque",
       "pump_speed",
       "'pump_torque' of {} needs the key 'pump_speed'",
       "add the speed at which the pump takes it, 'pump_speed: 2000 rpm'");
  need("lambda",
       "density",
       "'lambda' of {} needs the key 'density'",
       "add the density of the fluid, 'density: 860 kg/m^3'");
  need("lambda",
       "diameter",
       "'lambda' of {} needs the key 'diameter'",
       "add the outer diameter of the fluid circuit, 'diameter: 260 mm'");
  const auto mean = [&](std::string_view key, std::string_view other, std::string_view message) {
    m.rule({.kind = pointless,
            .key = key,
            .others = {other},
            .message = message,
            .hint = "remove it: 'pump_speed' goes with 'pump_torque', 'density' and 'diameter' "
                    "with 'lambda'"});
  };
  mean("pump_speed", "pump_torque", "'pump_speed' of {} means nothing without 'pump_torque'");
  mean("density", "lambda", "'density' of {} means nothing without 'lambda'");
  mean("diameter", "lambda", "'diameter' of {} means nothing without 'lambda'");
}

const Mapping<Characteristic>& characteristic_mapping() {
  static const Mapping<Characteristic> mapping(
      "characteristic",
      "Characteristic of a torque converter over its speed ratio, turbine to pump: tables, or "
      "expressions of 'speed_ratio'. Tables are interpolated by cubics that are as monotone as "
      "their points; beyond the points there is no value.",
      "{speed_ratio: [0, 0.5, 0.85, 1], torque_ratio: [2.1, 1.5, 1, 1], pump_torque: [150, 140, "
      "90, "
      "0], pump_speed: 2000 rpm}",
      [](auto& m) {
        m.key("speed_ratio", "The speed ratios of the tables, from 0, stall, to 1.")
            .may(
                &Characteristic::speed_ratio,
                [] { return called(list_of(bare_number(), "", "", {.least = 2}), "{1}"); },
                "[0, 0.5, 0.85, 1]");
        m.key("torque_ratio",
              "Turbine torque over pump torque, 1 from the coupling point on. The stator carries "
              "the difference; a fluid coupling, which has none, does not have this key.")
            .may(
                &Characteristic::torque_ratio,
                [] { return values_of(bare_number()); },
                "[2.1, 1.5, 1, 1]")
            .example("max(1, 2.1 - 1.3*speed_ratio)");
        m.key("pump_torque",
              "Torque of the pump at 'pump_speed'; at other speeds it is proportional to their "
              "square. MP2000 in a data sheet; (2000/K)^2 for a K factor (speed over square root "
              "of torque).")
            .may(
                &Characteristic::pump_torque,
                [] { return values_of(moment()); },
                "[150 N*m, 140 N*m, 90 N*m, 0]");
        m.key("pump_speed", "The speed of the pump at which 'pump_torque' is given.")
            .may(
                &Characteristic::pump_speed, [] { return called(speed(), "{1}"); }, "2000 rpm");
        m.key("lambda",
              "Instead of 'pump_torque': the torque of the pump divided by density, fifth power of "
              "the diameter and square of its speed in rad/s (VDI 2153), without a unit.")
            .may(
                &Characteristic::lambda,
                [] { return values_of(bare_number()); },
                "[2.1e-3, 2.0e-3, 1.2e-3, 0]");
        m.key("density", "Density of the fluid, with 'lambda'; a bare number is in kg/m^3.")
            .may(
                &Characteristic::density, [] { return called(density(), "{1}"); }, "860 kg/m^3");
        m.key("diameter", "Outer diameter of the fluid circuit, with 'lambda'.")
            .may(
                &Characteristic::diameter, [] { return called(size(), "{1}"); }, "260 mm");
        add_rules(m);
      });
  return mapping;
}

}  // namespace

Form<CharacteristicDescription> characteristic() {
  return characteristic_mapping().form();
}

}  // namespace kinestat
