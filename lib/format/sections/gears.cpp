// The section `gears`.
#include "format/sections/coupling_values.hpp"
#include "format/sections/sections.hpp"
#include "forms/number_forms.hpp"
#include "forms/value_forms.hpp"

namespace kinestat {

namespace {

Form<PlanetSide> side_of_axis() {
  return choice_of<PlanetSide>(
      {{"left", "to the left, seen from that axis"}, {"right", "to the right"}});
}

const Mapping<GearAxisDescription>& gear_axis() {
  static const Mapping<GearAxisDescription> mapping(
      "gear_axis",
      "An axis about which bodies turn. The first one in the section is the main axis.",
      "{bodies: [lay, idler1, idler2]}",
      [](auto& m) {
        m.key("bodies",
              "Bodies that turn about it; bodies joined to them by clutches follow, and so do "
              "carriers and the gears that mesh with their planets.")
            .needed(&GearAxisDescription::bodies,
                    list_of(body_name(), "a body", "", {.least = 1}),
                    "[lay, idler1, idler2]");
        m.key("centre_distance",
              "Its distance from the main axis, for all its gears; default: the mean of what their "
              "meshes with gears on the main axis require. If there are none, it is beyond the "
              "axis with which it meshes, in line with the main axis.")
            .may(&GearAxisDescription::centre_distance, size(), "80 mm");
        m.key("side",
              "On which side of the line from the main axis to its neighbour it is, if it meshes "
              "with another axis as well as the main axis.")
            .may(&GearAxisDescription::side, side_of_axis(), "right")
            .usual("left");
      });
  return mapping;
}

const Mapping<GearMember>& gear_member() {
  static const Mapping<GearMember> mapping(
      "gear_member",
      "A gear wheel. Two members may share a body (stepped planets).",
      "{body: sun1, teeth: 19}",
      [](auto& m) {
        m.key("body", "The body that carries the wheel.")
            .needed(&GearMember::body, body_name(), "sun1");
        m.key("teeth", "Number of teeth, a whole number.")
            .needed(&GearMember::teeth, teeth(), "19");
        m.key("internal", "true for a ring with internal teeth. Default false.")
            .may(&GearMember::internal, flag(), "true");
        m.key("count",
              "Number of equal planets; more than one adds checks of assembly and neighbours, and "
              "the loads of each planet. One represents all: its actions are those of all "
              "together.")
            .may(&GearMember::count, planet_count(), "3")
            .usual("1");
        m.key("load_sharing",
              "Load of the most heavily loaded of these planets over the mean of all: with 1.15, "
              "one of three planets carries 1.15/3. It raises the reported loads of its meshes and "
              "its bearing, but no torque. All planets of a set share one value.")
            .may(&GearMember::load_sharing, at_least_one(), "1.15")
            .usual("1");
        m.key(
             "centre_distance",
             "Distance of a planet from the axis of its carrier, or of a shaft from the main axis; "
             "default: the mean of what its meshes with gears on that axis require. A gear that "
             "has one does not turn on the main axis.")
            .may(&GearMember::centre_distance, size(), "50 mm");
        m.key("side",
              "On which side of the line from the main axis to its neighbour a further planet is, "
              "if it meshes with another planet.")
            .may(&GearMember::side, side_of_axis(), "right")
            .usual("left");
        m.rule({.kind = FormRule::Kind::together,
                .key = "load_sharing",
                .others = {"count"},
                .message = "'load_sharing' of {0} needs the key 'count'",
                .hint = "add how many planets share the load, 'count: 3'"});
        m.rule({.kind = FormRule::Kind::unless_true,
                .key = "internal",
                .others = {"count", "centre_distance", "side"},
                .message = "{0} is a ring and cannot have '{1}'",
                .hint = "remove '{1}', or 'internal: true' if it is a planet"});
      });
  return mapping;
}

FormRule one_pressure_angle() {
  return {.kind = FormRule::Kind::excludes,
          .key = "normal_pressure_angle",
          .others = {"pressure_angle"},
          .message = "{0} cannot have both 'pressure_angle' and 'normal_pressure_angle'",
          .hint = "keep one: tan(pressure_angle) = tan(normal_pressure_angle)/cos(helix_angle)"};
}

const Mapping<MeshDescription>& mesh() {
  static const Mapping<MeshDescription> mapping(
      "mesh",
      "Two members in mesh; it becomes a coupling of type gear of this name.",
      "{members: [sun1, planet5], carrier: carrier}",
      [](auto& m) {
        m.key("members", "The two members in mesh: [tail, head].")
            .pair(&MeshDescription::first,
                  &MeshDescription::second,
                  name_of("two gear members"),
                  "[sun1, planet5]",
                  "write members: [first, second]; a gear that meets two others has two meshes");
        m.key("carrier", "The body that holds the two centres apart; default: the ground.")
            .may(&MeshDescription::carrier, body_name(), "carrier");
        m.key("at", "Position of the mesh along the axis.")
            .may(&MeshDescription::at, length(), "10 mm");
        m.key("module", "Module of this mesh; default: that of 'gears'.")
            .may(&MeshDescription::module, size(), "2.5 mm");
        m.key("pressure_angle",
              "Pressure angle of this mesh in the transverse plane; default: that of 'gears'.")
            .may(&MeshDescription::pressure_angle, acute_angle(), "25 deg");
        m.key("normal_pressure_angle", "Instead: the same in the normal plane.")
            .may(&MeshDescription::normal_pressure_angle, acute_angle(), "20 deg");
        m.rule(one_pressure_angle());
        m.key("helix_angle",
              "Helix angle of this mesh, positive if its tail is right-handed; default: that of "
              "'gears'.")
            .may(&MeshDescription::helix_angle, angle(), "15 deg");
      });
  return mapping;
}

void declare_teeth(Mapping<GearsDescription>& m) {
  m.key("module",
        "Module of the teeth: pitch diameter over number of teeth; of helical gears the transverse "
        "module, which is the normal module over cos(helix_angle). Optional if meshes have their "
        "own or members have a centre_distance.")
      .may(&GearsDescription::module, size(), "2 mm");
  m.key("pressure_angle", "Pressure angle of the teeth in the transverse plane.")
      .may(&GearsDescription::pressure_angle, acute_angle(), "20 deg")
      .usual(kUsualPressureAngle);
  m.key("normal_pressure_angle",
        "Instead: pressure angle in the normal plane, as given by catalogues and cutters of "
        "helical gears: tan(pressure_angle) = tan(normal_pressure_angle)/cos(helix_angle).")
      .may(&GearsDescription::normal_pressure_angle, acute_angle(), "20 deg");
  m.rule(one_pressure_angle());
  m.key("helix_angle",
        "Helix angle of the teeth; positive if the first gear of the first mesh is right-handed. "
        "Hands alternate along the train.")
      .may(&GearsDescription::helix_angle, angle(), "15 deg")
      .usual("0");
  m.key("flank", "Which flank carries the load.")
      .may(&GearsDescription::flank, flank_of_teeth(), "fixed")
      .usual("loaded");
}

}  // namespace

const Mapping<GearsDescription>& gears_section() {
  static const Mapping<GearsDescription> mapping(
      "",
      "",
      "{module: 2 mm, members: {sun: {body: sun, teeth: 24}, planet: {body: planet, teeth: 18}}, "
      "meshes: {sp: {members: [sun, planet], carrier: carrier}}}",
      [](auto& m) {
        m.write_in_lines();
        declare_teeth(m);
        m.key("axes",
              "Axes about which several bodies turn, by name, the main axis first: lay shafts with "
              "idlers that nothing joins to them, hollow shafts, a final drive. Needed only for "
              "what does not follow from meshes, clutches and carriers.")
            .may(&GearsDescription::axes,
                 named(&GearAxisDescription::name,
                       gear_axis().form(),
                       {.item = "an axis", .name_definition = "new_name"},
                       "axis '{0}'"),
                 "{main: {bodies: [input]}, final: {bodies: [differential]}}");
        m.key("members", "The gear wheels, by name.")
            .needed(&GearsDescription::members,
                    named(&GearMember::name,
                          gear_member().form(),
                          {.item = "a gear member", .name_definition = "new_name"},
                          "gear member '{0}'"),
                    "{sun1: {body: sun1, teeth: 19}, planet5: {body: planet5, teeth: 15}}")
            .add_hint("'members:' with lines 'sun: {body: …, teeth: …}'");
        m.key("meshes", "The meshes, by name; each becomes a coupling of this name.")
            .needed(&GearsDescription::meshes,
                    named(&MeshDescription::name,
                          mesh().form(),
                          {.item = "a mesh", .name_definition = "new_name"},
                          "mesh '{0}'"),
                    "{h: {members: [sun1, planet5], carrier: carrier}}")
            .add_hint("'meshes:' and below it lines 'h: {members: [sun, planet], carrier: …}'");
      });
  return mapping;
}

}  // namespace kinestat
