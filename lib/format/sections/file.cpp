#include "format/numbers.hpp"
#include "format/sections/sections.hpp"
#include "format/value_forms.hpp"

namespace kinestat {

namespace {

using File = MechanismDescription;

const Mapping<File>& statics_section() {
  static const Mapping<File> mapping("", "", "{indeterminate: minimum_norm}", [](auto& m) {
    m.key("indeterminate", "What is reported of actions that equilibrium leaves open.")
        .may(&File::indeterminate,
             choice_of<IndeterminateChoice>(
                 {{"report", "they are listed, without values"},
                  {"minimum_norm",
                   "the smallest actions in equilibrium; couples are divided by a "
                   "characteristic length"},
                  {"stiffness", "by the stiffness of the couplings"}}),
             "minimum_norm")
        .required()
        .usual("report");
  });
  return mapping;
}

void declare_loads(Mapping<File>& m) {
  m.key("loads",
        "Forces and couples on bodies from outside, in every case; a case may replace them by "
        "name.")
      .may(&File::loads, loads())
      .at(&File::loads_where);
  m.key("gravity",
        "The acceleration of gravity as a vector, [x, y] in the plane, [x, y, z] in space; it acts "
        "on bodies with a mass.")
      .may(&File::gravity, vector_of(acceleration(), "", "", {}), "[0, -9.81]")
      .offer("0, ${1:-9.81 m/s^2}", "in the plane, down is -y")
      .offer("0, 0, ${1:-9.81 m/s^2}", "in space, down is -z");
  m.key("losses",
        "What the meshes lose, from which efficiencies follow. Bearings and guides have 'friction' "
        "of their own.")
      .may(&File::losses, losses_section().form());
  m.key("statics", "How the statics are solved.").group(statics_section(), &File::statics_where);
}

void declare_tasks(Mapping<File>& m) {
  m.key("cases",
        "The cases to analyse, each with a label: what is known in it. Everything else is solved.")
      .may(&File::cases,
           cases(),
           "{design point: {motion: {load: 1 rad/s}, action: {load: 1 N*m}, input: drive, output: "
           "load}}");
  m.key("shift",
        "A gearbox: which elements engage for which gear. Every combination is enumerated and "
        "classed; every gear is also a case of its name.")
      .may(&File::shift, shift_section().form());
  m.key("motion",
        "A finite motion from the drawn position: the drives run through their ranges, everything "
        "else follows.")
      .may(&File::motion, motion_section().form());
  m.key("sweep", "Analyses every combination of some parameters, in the order of the file.")
      .may(&File::sweep, sweep_section().form());
  m.key("published", "Values that the source prints, against which the report is checked.")
      .may(&File::published,
           published(),
           "[{value: /cases/M1/ratio, is: 2.847, tolerance: 0.0005, where: Tab. 5.15}]");
}

}  // namespace

const Mapping<MechanismDescription>& file_sections() {
  static const Mapping<File> mapping("", "", "", [](auto& m) {
    m.key("actuators",
          "Active couplings by name: where motions and actions are brought in or taken out. "
          "Clutches and brakes are actuators of their own names already.")
        .may(&File::actuators,
             named(&ActuatorDescription::name,
                   actuator().form(),
                   {.item = "an actuator", .name_definition = "new_name"},
                   "actuator '{0}'"),
             "{drive: {coupling: a}, load: {coupling: d}}");
    declare_loads(m);
    declare_tasks(m);
  });
  return mapping;
}

}  // namespace kinestat
