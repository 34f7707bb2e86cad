// The section `actuators`.
#include "format/sections/sections.hpp"
#include "forms/collections.hpp"
#include "forms/value_forms.hpp"

namespace kinestat {

namespace {

const Mapping<ActuatorDescription>& actuator() {
  static const Mapping<ActuatorDescription> mapping(
      "actuator",
      "An active coupling: an action is applied to a freedom of a coupling.",
      "{coupling: a}",
      [](auto& m) {
        m.key("coupling", "The coupling that it drives.")
            .needed(&ActuatorDescription::coupling, coupling_name(), "a");
        m.key("freedom",
              "The freedom of the coupling that it drives; required if the coupling has several.")
            .may(&ActuatorDescription::freedom, free_name(), "wz");
      });
  return mapping;
}

}  // namespace

Form<std::vector<ActuatorDescription>> actuators() {
  return named(&ActuatorDescription::name,
               actuator().form(),
               {.item = "an actuator", .name_definition = "new_name"},
               "actuator '{0}'");
}

}  // namespace kinestat
