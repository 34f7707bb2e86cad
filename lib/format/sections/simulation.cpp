// The section `simulation`.
#include "format/sections/sections.hpp"
#include "forms/collections.hpp"
#include "forms/number_forms.hpp"
#include "forms/value_forms.hpp"

namespace kinestat {

namespace {

Form<std::vector<Assignment>> known_values(const Form<Value>& value) {
  return values_by_name(&Assignment::target,
                        &Assignment::value,
                        value,
                        {.elements = "names to values", .name_definition = "target"},
                        "'{0}'");
}

Form<Value> integration_tolerance() {
  return number_form(
      "integration_tolerance", "A number from 1e-13 to 1e-3.", {"1e-9"}, kIntegrationTolerance);
}

Form<Value> restitution() {
  return number_form("restitution", "A number from 0, below 1.", {"0.7"}, kLostShare);
}

const Mapping<FreedomState>& freedom_state() {
  static const Mapping<FreedomState> mapping(
      "freedom_state",
      "Position and speed of a freedom.",
      "{position: 120 deg, speed: 0}",
      [](auto& m) {
        m.key("position", "Measured from the drawn position.")
            .may(&FreedomState::position, drawn_position(), "120 deg");
        m.key("speed", "Of the head relative to the tail.")
            .may(&FreedomState::speed, speed(), "20 rad/s");
        m.rule({.kind = FormRule::Kind::any_of,
                .others = {"position", "speed"},
                .message = "{} has neither 'position' nor 'speed'",
                .hint = "write for example {position: 90 deg}, or {speed: 10 rad/s}"});
      });
  return mapping;
}

const Mapping<StopDescription>& stop() {
  static const Mapping<StopDescription> mapping(
      "stop", "The limits of a freedom.", "{from: -0.8, restitution: 0.7}", [](auto& m) {
        m.key("from", "Its least position, measured from the drawn one.")
            .may(&StopDescription::from, drawn_position(), "-30 deg");
        m.key("to", "Its greatest position, measured from the drawn one.")
            .may(&StopDescription::to, drawn_position(), "90 deg");
        m.key("restitution",
              "Coefficient of restitution: speed after an impact over that before it.")
            .may(&StopDescription::restitution, restitution(), "0.7")
            .usual("0");
        m.rule({.kind = FormRule::Kind::any_of,
                .others = {"from", "to"},
                .message = "{} has neither 'from' nor 'to'",
                .hint = "write for example {from: -30 deg, to: 90 deg}"});
      });
  return mapping;
}

Form<std::vector<FreedomState>> freedom_states() {
  return named(&FreedomState::target,
               freedom_state().form(),
               {.elements = "names to places and speeds", .name_definition = "target"},
               "'{0}'");
}

Form<std::vector<StopDescription>> freedom_stops() {
  return named(&StopDescription::target,
               stop().form(),
               {.elements = "names to stops", .name_definition = "target"},
               "the stop of '{0}'");
}

}  // namespace

const Mapping<SimulationDescription>& simulation_section() {
  static const Mapping<SimulationDescription> mapping(
      "",
      "",
      "{action: {drive: 4 N*m}, start: {drive: {position: 0, speed: 0}}, time: 5 s, steps: 500}",
      [](auto& m) {
        m.key("action",
              "The action on the head at each actuator that is not held; it may follow curves, "
              "such as over the speed of a motor. Loads, weights and springs act in addition.")
            .may(&SimulationDescription::actions, known_values(action()), "{drive: 4 N*m}");
        m.key("motion", "Freedoms held at a constant speed, whatever action that takes.")
            .may(&SimulationDescription::motions, known_values(speed()), "{belt: 0.3}");
        m.key("start",
              "Initial positions and speeds of freedoms: actuators or COUPLING.FREEDOM, no more "
              "than are independent. Anything not named starts as drawn and at rest.")
            .may(&SimulationDescription::start,
                 freedom_states(),
                 "{drive: {position: 120 deg, speed: 0}}");
        m.key("until",
              "Positions or speeds of freedoms: the first one reached ends the simulation early.")
            .may(&SimulationDescription::until, freedom_states(), "{drive: {position: 720 deg}}");
        m.key("stops", "The limits of freedoms; impacts there follow Newton's law of restitution.")
            .may(&SimulationDescription::stops,
                 freedom_stops(),
                 "{drive: {from: -30 deg, to: 90 deg, restitution: 0.7}}");
        m.key("time", "Duration.").needed(&SimulationDescription::time, duration(), "5 s");
        m.key("steps", "Number of steps between the rows, which are equal in time.")
            .may(&SimulationDescription::steps, step_count(), "500")
            .usual(usual_number<kUsualSteps>());
        m.key("tolerance",
              "Permitted error of an integration step: positions in radians or as a fraction of "
              "the mechanism's size, speeds relative to the fastest.")
            .may(&SimulationDescription::tolerance, integration_tolerance(), "1e-9")
            .usual("1e-9");
        m.key("report",
              "What each row reports: position, velocity, acceleration, action, reaction, power, "
              "energy, "
              "or names of freedoms, actuators, actions, couplings, loads and columns. Without it: "
              "everything except the actions and reactions of couplings, and powers.")
            .may(&SimulationDescription::report, one_or_more(column_name()), "[a, action]");
      });
  return mapping;
}

}  // namespace kinestat
