// The keys of the file itself.
#include <string>

#include <fmt/format.h>

#include "core/version.hpp"
#include "format/sections/sections.hpp"
#include "forms/alternatives.hpp"
#include "forms/number_forms.hpp"
#include "forms/value_forms.hpp"

namespace kinestat {

namespace {

using File = MechanismDescription;

constexpr const char* kMeaning =
    "A mechanism, the cases to analyse and, optionally, a shift table, a motion, a sweep or a "
    "synthesis task. Numbers may be expressions with units and parameters: 20 deg, (N1 + "
    "N5)/2*module.";

const std::string& version_hint() {
  static const std::string hint = fmt::format("the file must say 'kinestat: {}'", kFormatVersion);
  return hint;
}

bool is_positive_whole(const YamlNode& node) {
  return node.kind == YamlKind::scalar && !node.text.empty() && node.text.front() != '0' &&
         node.text.find_first_not_of("0123456789") == std::string::npos;
}

Form<int> version() {
  static const std::string text = std::to_string(kFormatVersion);
  return {.shape = {.kind = FormKind::constant, .sketch = text},
          .read = [](const FileValue& value) -> std::optional<int> {
            const YamlNode& node = value.node;
            if (node.kind == YamlKind::scalar && node.text == text) {
              return kFormatVersion;
            }
            if (is_positive_whole(node)) {
              value.found.error("E0301",
                                node.where,
                                fmt::format("format version {} was made for a newer kinestat; "
                                            "this one reads version {}",
                                            node.text,
                                            text),
                                "update kinestat, or rewrite the file in the older format");
            } else {
              value.found.error("E0301",
                                node.where,
                                "the format version is not a positive whole number",
                                version_hint());
            }
            return std::nullopt;
          },
          .write = [](int number) { return single_text(std::to_string(number)); }};
}

Form<Space> space_word() {
  return called(choice_of<Space>({{"planar", "points are [x, y]; rotations are about z"},
                                  {"spatial", "points are [x, y, z]"}}),
                "the space");
}

const Mapping<File>& statics_section() {
  static const Mapping<File> mapping("", "", "{indeterminate: minimum_norm}", [](auto& m) {
    m.key("indeterminate", "What is reported for actions that equilibrium does not determine.")
        .may(&File::indeterminate,
             choice_of<IndeterminateChoice>(
                 {{"report", "they are listed without values"},
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

Form<OrderChoice> order_word() {
  return choice_of<OrderChoice>(
      {{"minimal", "only the coordinates that the screws of the mechanism need"},
       {"planar", "three coordinates"},
       {"spatial", "six coordinates"}});
}

const Mapping<File>& order_section() {
  static const Mapping<File> mapping(
      "", "", "{kinematics: minimal, statics: minimal}", [](auto& m) {
        m.key("kinematics", "Order of the motion screws.")
            .may(&File::kinematic_order, order_word(), "planar")
            .usual("minimal");
        m.key("statics", "Order of the action screws.")
            .may(&File::static_order, order_word(), "spatial")
            .usual("minimal");
      });
  return mapping;
}

void declare_head(Mapping<File>& m) {
  m.key("kinestat", "Version of this file format.")
      .passed_over(version(), version().shape.sketch, std::optional(kFormatVersion))
      .required({.code = "E0301", .message = "the format version is missing"})
      .add_hint(version_hint());
  m.key("name", "Title of the mechanism, for reports.")
      .may(&File::name, called(text(), "the name"), "Four-bar linkage");
  m.key("source", "Where the mechanism and its numbers come from.")
      .may(&File::source, called(text(), "the source"), "Cazangi 2008, section 3.11");
  m.key("units",
        "The units of bare numbers in this file and of reports. A unit is a name, or several "
        "joined by '*', '/' and '^', such as N*mm.")
      .group(&File::units, units_section());
  m.key("space", "Whether points and vectors have two or three components.")
      .may(&File::space, space_word(), "planar")
      .usual("spatial");
  m.own_keys({.key = "x-",
              .meaning = "Your own notes, which the program ignores.",
              .shape = FormShape{.sketch = "anything"},
              .examples = {"checked against the drawing"}});
}

void declare_network(Mapping<File>& m) {
  m.key("ground", "The fixed body. It is not listed in 'bodies'.")
      .may(&File::ground, called(new_body_name("the ground"), "the ground"), "frame")
      .required()
      .add_hint("'ground: NAME', the body that does not move");
  m.key("bodies",
        "The moving bodies: a list of names, or a mapping of names to attributes, which may be "
        "empty.")
      .may(&File::bodies, bodies, "[crank, coupler, rocker]")
      .example("{crank: , planet: {reference: [0, 17, 0]}}")
      .required()
      .add_hint("'bodies: [NAME, NAME, …]'; of a coupling 'bodies: [TAIL, HEAD]'");
  m.key("couplings",
        "The couplings: NAME: {type: …, bodies: [tail, head], …}. Motions are those of the head "
        "relative to the tail, actions those of the tail on the head.")
      .may(&File::couplings, couplings, "{a: {type: revolute, bodies: [frame, crank], at: [0, 0]}}")
      .required()
      .add_hint("'couplings:' and below it lines 'name: {type: …, bodies: […], …}'");
}

void declare_structure(Mapping<File>& m) {
  m.key("parameters",
        "Named numbers for use in expressions, in any order. --set NAME=VALUE changes them.")
      .may(&File::parameters, parameters, "{N1: 19, alpha: 20 deg, crank: 2.5 * 1.2}");
  m.key("tree",
        "The couplings of the spanning tree, as many as there are moving bodies; default: chosen "
        "by the program. It decides which circuits and cut-sets are used, not the results.")
      .may(&File::tree, one_or_more(coupling_name()), "[a, b, c]")
      .at_value(&File::tree_where);
  m.key("order", "The number of coordinates in which the equations are written.")
      .group(order_section())
      .at_value(&File::order_where);
}

void declare_trains(Mapping<File>& m) {
  m.key("gears",
        "Gear trains defined by numbers of teeth, from which the geometry follows: suns and rings "
        "are centred on the world z axis, the first planet is on +y.")
      .may(&File::gears, gears_section);
  m.key("cables", "Cables, belts and chains over pulleys, by name.")
      .may(&File::cables,
           cables,
           "{rope: {over: [{body: block_a, at: [0, 0]}, {pulley: wheel, radius: 1, wrap: "
           "clockwise}, {body: block_b, at: [2, 0]}]}}")
      .at(&File::cables_where);
}

void declare_actuators(Mapping<File>& m) {
  m.key("actuators",
        "Active couplings by name: where motions and actions enter or leave. Clutches and brakes "
        "are already actuators under their own names.")
      .may(&File::actuators, actuators, "{drive: {coupling: a}, load: {coupling: d}}");
}

void declare_loads(Mapping<File>& m) {
  m.key("loads",
        "External forces and couples on bodies, in every case; a case may replace them by name.")
      .may(&File::loads, loads)
      .at(&File::loads_where);
  m.key("springs", "Springs, dampers and gas springs by name; they act in every case.")
      .may(&File::springs, springs);
  m.key("curves",
        "Values over time, or over the position or the speed of an actuator, by name. Loads and "
        "actions of cases may name them.")
      .may(&File::curves, curves);
  m.key("gravity",
        "The acceleration of gravity as a vector, [x, y] in the plane, [x, y, z] in space; it acts "
        "on bodies with a mass.")
      .may(&File::gravity, vector_of(acceleration(), "", "", {}), "[0, -9.81 m/s^2]")
      .offer("0, ${1:-9.81 m/s^2}", "in the plane, down is -y")
      .offer("0, 0, ${1:-9.81 m/s^2}", "in space, down is -z");
  m.key("losses",
        "Gear mesh losses, from which efficiencies follow. Bearings and guides have 'friction' "
        "instead.")
      .may(&File::losses, losses_section);
  m.key("statics", "How the statics are solved.").group(statics_section()).at(&File::statics_where);
}

void declare_tasks(Mapping<File>& m) {
  m.key("cases",
        "The cases to analyse, by label: what is known in each. Everything else is solved.")
      .may(&File::cases,
           cases,
           "{design point: {motion: {load: 1 rad/s}, action: {load: 1 N*m}, input: drive, output: "
           "load}}");
  m.key("shift",
        "A gearbox: which elements engage for which gear. Every combination is enumerated and "
        "classified; every gear is also a case of its name.")
      .may(&File::shift, shift_section);
  m.key("duty",
        "What a transmission does and for how long: energies, losses, and the loads on gears and "
        "bearings.")
      .may(&File::duty, duty_section);
  m.key("motion",
        "A finite motion from the drawn position: the drives run through their ranges, everything "
        "else follows.")
      .may(&File::motion, motion_section);
  m.key("dynamics",
        "Evaluations of the whole motion, if bodies have inertia: flywheel, harmonics, "
        "counterweights, and the speed at which contacts separate.")
      .may(&File::dynamics, dynamics_section);
  m.key("simulation",
        "The motion in time that follows from the forces, from a given start, if bodies have "
        "inertia: positions, speeds and energies.")
      .may(&File::simulation, simulation_section);
  m.key("sweep", "Analyses every combination of some parameters, in the order of the file.")
      .may(&File::sweep, sweep_section);
  m.key("published", "Values printed in the source, against which the report is checked.")
      .may(&File::published,
           published,
           "[{value: /cases/M1/ratio, is: 2.847, tolerance: 0.0005, where: Tab. 5.15}]");
  m.key("synthesis",
        "Finds linkages that guide a plane through two to five positions, finitely or "
        "infinitesimally separated. It is planar; a file may contain this section alone.")
      .may(&File::synthesis, synthesis_section);
  m.rule({.kind = FormRule::Kind::together,
          .key = "dynamics",
          .others = {"motion"},
          .message = "'dynamics' is of a motion, and the file has no section 'motion'",
          .hint = "add for example motion: {drive: NAME, to: 360 deg, case: LABEL}"});
  m.rule({.kind = FormRule::Kind::alone,
          .key = "synthesis",
          .others = {"ground", "bodies", "couplings"}});
}

}  // namespace

const Mapping<MechanismDescription>& file_sections() {
  // Never taken apart: every process would pay for it at its end.
  static const Mapping<File>& mapping = *new Mapping<File>("", kMeaning, "", [](auto& m) {
    declare_head(m);
    declare_network(m);
    declare_structure(m);
    declare_trains(m);
    declare_actuators(m);
    declare_loads(m);
    declare_tasks(m);
  });
  return mapping;
}

FileValue whole_file(const YamlNode& root, Diagnostics& found) {
  constexpr SourceRange kBegin{.line = 1, .column = 1, .length = 1};
  FileValue file{.node = root,
                 .what = {},
                 .where = kBegin,
                 .place = kBegin,
                 .space = Space::spatial,
                 .found = found};
  if (const YamlNode* word = root.find("space")) {
    Diagnostics unheard;  // what is wrong is said once it is read
    file.space = space_word().read({.node = *word,
                                    .what = {},
                                    .where = word->where,
                                    .place = word->where,
                                    .space = std::nullopt,
                                    .found = unheard});
  }
  return file;
}

}  // namespace kinestat
