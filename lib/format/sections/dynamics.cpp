// The section `dynamics`.
#include "format/sections/sections.hpp"
#include "forms/collections.hpp"
#include "forms/number_forms.hpp"
#include "forms/value_forms.hpp"

namespace kinestat {

namespace {

Form<Value> fluctuation() {
  return number_form(
      "fluctuation", "A number above 0 and below 1.", {"0.02", "1/50"}, kFluctuation);
}

Form<Value> harmonic_count() {
  return number_form("harmonics", "A whole number from 1 to 100.", {"6"}, kHarmonics);
}

const Mapping<FlywheelDescription>& flywheel() {
  static const Mapping<FlywheelDescription> mapping(
      "flywheel",
      "A flywheel that keeps the speed of a cycle nearly constant.",
      "{at: motor, fluctuation: 0.02}",
      [](auto& m) {
        m.key("at", "The actuator with whose freedom it turns, at a constant ratio to the drive.")
            .needed(&FlywheelDescription::at, name_of("an actuator"), "motor");
        m.key("fluctuation",
              "Coefficient of fluctuation: (greatest - least speed of the cycle) / mean speed.")
            .needed(&FlywheelDescription::fluctuation, fluctuation(), "0.02");
      });
  return mapping;
}

const Mapping<BalanceDescription>& balance() {
  static const Mapping<BalanceDescription> mapping(
      "balance",
      "Counterweights with the least mean square shaking force.",
      "{bodies: [crank]}",
      [](auto& m) {
        m.key("bodies",
              "The bodies that may carry a counterweight; each turns about an axis fixed to the "
              "ground.")
            .needed(&BalanceDescription::bodies, one_or_more(body_name(), 1), "[crank]");
      });
  return mapping;
}

}  // namespace

const Mapping<DynamicsDescription>& dynamics_section() {
  static const Mapping<DynamicsDescription> mapping(
      "", "", "{flywheel: {at: motor, fluctuation: 0.02}, harmonics: 6}", [](auto& m) {
        m.key("actuators",
              "Actuators whose peak and RMS action, powers and energies over the whole motion are "
              "reported, in addition to its energy balance.")
            .may(
                &DynamicsDescription::actuators, one_or_more(name_of("an actuator"), 1), "[motor]");
        m.key("flywheel", "The moment of inertia that keeps the speed of a cycle nearly constant.")
            .may(&DynamicsDescription::flywheel, flywheel);
        m.key("harmonics",
              "Highest order, relative to the rotation of the drive, of the harmonics of drive "
              "torques, shaking wrench and ground wrench.")
            .may(&DynamicsDescription::harmonics, harmonic_count(), "6");
        m.key("balance", "Counterweights against the shaking force.")
            .may(&DynamicsDescription::balance, balance);
        m.key("limit_speed",
              "Contacts and cable segments: the steady drive speed at which the first of them "
              "would lose its force.")
            .may(&DynamicsDescription::limit_speed, one_or_more(coupling_name(), 1), "[cam]");
        m.rule({.kind = FormRule::Kind::any_of,
                .others = {"actuators", "flywheel", "harmonics", "balance", "limit_speed"},
                .message = "{} requests nothing",
                .hint = "add for example harmonics: 6, or flywheel: {at: ACTUATOR, fluctuation: "
                        "0.02}"});
      });
  return mapping;
}

}  // namespace kinestat
