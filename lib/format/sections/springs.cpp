// The section `springs`.
#include "format/sections/coupling_values.hpp"
#include "format/sections/sections.hpp"
#include "forms/number_forms.hpp"
#include "forms/value_forms.hpp"

namespace kinestat {

namespace {

Form<Value> spring_stiffness() {
  return number_form("spring_stiffness",
                     "Force per length (default N/m), about a freedom that turns couple per angle "
                     "(default N*m/rad).",
                     {"8 N/mm", "5 N*m/rad"},
                     kNotNegative);
}

Form<Value> spring_damping() {
  return number_form("spring_damping",
                     "Force per velocity (default N*s/m), about a freedom that turns couple per "
                     "angular velocity (default N*m*s/rad).",
                     {"200 N*s/m"},
                     kNotNegative);
}

const Mapping<GasSpringDescription>& gas() {
  static const Mapping<GasSpringDescription> mapping(
      "gas_spring",
      "A gas spring, which pushes.",
      "{force: 500 N, length: 480 mm, stroke: 200 mm, ratio: 1.35, exponent: 1.2}",
      [](auto& m) {
        m.key("force", "Its force when extended.")
            .needed(&GasSpringDescription::force, force(), "500 N");
        m.key("length", "The distance between its ends there.")
            .needed(&GasSpringDescription::length, size(), "480 mm");
        m.key("stroke", "How far it can be compressed.")
            .needed(&GasSpringDescription::stroke, size(), "200 mm");
        m.key("ratio", "Its force when compressed over that when extended, at least 1.")
            .needed(&GasSpringDescription::ratio, at_least_one(), "1.35");
        m.key("exponent",
              "Polytropic exponent of the gas: 1 for slow motion, up to 1.4 for fast motion.")
            .may(&GasSpringDescription::exponent, above_zero(), "1.2")
            .usual("1");
      });
  return mapping;
}

const Mapping<SpringDescription>& spring() {
  static const Mapping<SpringDescription> mapping(
      "spring",
      "A spring, damper or gas spring between two bodies, or acting on a freedom.",
      "{coupling: hinge, stiffness: 5 N*m/rad, free: 30 deg}",
      [](auto& m) {
        m.key("bodies", "The two bodies that it joins at their points 'at'.")
            .may(&SpringDescription::bodies,
                 list_of(body_name(), "a body of {0}", "", {2, 2}),
                 "[frame, follower]");
        m.key("at", "A point of each of the two bodies, as drawn.")
            .may(&SpringDescription::at, points_of_bodies(), "{frame: [0, 80], follower: [0, 60]}");
        m.key("coupling", "The coupling on whose freedom it acts, instead of bodies and points.")
            .may(&SpringDescription::coupling, coupling_name(), "hinge");
        m.key("freedom", "The freedom, if the coupling has several, such as wz or vx.")
            .may(&SpringDescription::freedom, free_name(), "wz");
        m.key("stiffness", "Change of its force with its length or with the freedom.")
            .may(&SpringDescription::stiffness, spring_stiffness());
        m.key("damping", "Change of its force with the speed of these; no force in a case at rest.")
            .may(&SpringDescription::damping, spring_damping());
        m.key("free",
              "Position of the freedom at which it has no force, measured from the drawn one.")
            .may(&SpringDescription::free, drawn_position(), "30 deg")
            .usual("0");
        m.key("free_length",
              "Distance between the points at which it has no force; 0 of a zero-length spring, "
              "whose force grows with all of its length; default: as drawn.")
            .may(&SpringDescription::free_length, non_negative_length(), "50 mm");
        m.key("drawn",
              "Instead of these: its action in the drawn position, for a freedom that of the tail "
              "on the head, between points positive if it pushes.")
            .may(&SpringDescription::drawn, action(), "-300 N");
        m.key("force",
              "In addition: its force, between points positive if it pushes, for a freedom that of "
              "the tail on the head. It may name curves.")
            .may(&SpringDescription::force, action(), "300 N");
        m.key("acts", "Between points: whether it pushes and pulls, or does only one of these.")
            .may(&SpringDescription::acts,
                 choice_of<SpringSense>({{"both", "pushes and pulls"},
                                         {"push", "only pushes, as a spring that is not attached"},
                                         {"pull", "only pulls, as a rubber band"}}),
                 "push")
            .usual("both");
        m.key("gas", "A gas spring between the points.").may(&SpringDescription::gas, gas);
        m.rule({.kind = FormRule::Kind::one_of,
                .others = {"bodies", "coupling"},
                .message = "{} needs one of 'bodies' and 'coupling'",
                .hint = "write bodies: [TAIL, HEAD] with at: {TAIL: […], HEAD: […]}, or coupling: "
                        "NAME"});
        m.rule({.kind = FormRule::Kind::together,
                .key = "bodies",
                .others = {"at"},
                .message = "{} has no points at which it holds the bodies",
                .hint = "add at: {TAIL: […], HEAD: […]}, in the drawn position"});
        m.rule({.kind = FormRule::Kind::pointless,
                .key = "gas",
                .others = {"bodies"},
                .message = "{} is a gas spring, which needs two points",
                .hint = "write bodies: [TAIL, HEAD] and at: {TAIL: […], HEAD: […]}"});
        for (const char* const key : {"free", "freedom"}) {
          m.rule({.kind = FormRule::Kind::pointless,
                  .key = key,
                  .others = {"coupling"},
                  .message = "{} joins two points, which have no freedom",
                  .hint = "write 'free_length' for the distance at which it has no force, or "
                          "coupling: NAME instead of bodies and at"});
        }
        for (const char* const key : {"free_length", "acts"}) {
          m.rule({.kind = FormRule::Kind::pointless,
                  .key = key,
                  .others = {"bodies"},
                  .message = "{} is of a freedom, which has no length",
                  .hint =
                      "write 'free' for the position at which it has no force, or bodies and at "
                      "instead of the coupling"});
        }
        m.rule({.kind = FormRule::Kind::any_of,
                .others = {"stiffness", "damping", "gas", "force"},
                .message = "{} has neither 'stiffness' nor 'damping' nor 'gas' nor 'force'",
                .hint = "add for example stiffness: 8 N/mm"});
      });
  return mapping;
}

}  // namespace

Form<std::vector<SpringDescription>> springs() {
  auto form = named(&SpringDescription::name,
                    spring().form(),
                    {.item = "a spring", .name_definition = "new_name"},
                    "spring '{0}'");
  form.shape.definition = "springs";
  form.shape.meaning = "Springs, dampers and gas springs, by name.";
  form.shape.examples = {"{hinge: {coupling: d, stiffness: 5 N*m/rad, free: 30 deg}}"};
  return form;
}

}  // namespace kinestat
