// The sections `loads`, at the top level and in a case, and `gravity`.
#include "format/sections/sections.hpp"
#include "forms/number_forms.hpp"
#include "forms/value_forms.hpp"

namespace kinestat {

namespace {

void declare_rules(Mapping<LoadDescription>& m) {
  m.rule({.kind = FormRule::Kind::any_of,
          .others = {"force", "couple"},
          .message = "{} has neither 'force' nor 'couple'",
          .hint = "add 'force: […]' with its point 'at: […]', or 'couple: …'"});
  m.rule({.kind = FormRule::Kind::together,
          .key = "force",
          .others = {"at"},
          .message = "the force of {} has no point where it acts",
          .hint = "add 'at: […]', a point in the drawn position"});
  m.rule({.kind = FormRule::Kind::pointless,
          .key = "at",
          .others = {"force"},
          .message = "{} has 'at' but no force that acts there",
          .hint = "remove 'at': a couple is the same at every point; or add 'force: […]'"});
}

Form<PointDescription> force_vector() {
  return vector_of(force(),
                   "force_vector",
                   "A force as a vector: [x, y] in the plane, [x, y, z] in space.",
                   {"[0, -250]", "[100 N, 0, 0]"});
}

const Mapping<LoadDescription>& load() {
  static const Mapping<LoadDescription> mapping(
      "body_load",
      "An external force, couple or both on a body. In a case it replaces the load of the same "
      "name at the top level.",
      "{body: coupler, at: [3, 4], force: [0, -250 N]}",
      [](auto& m) {
        m.key("body", "The body on which the load acts.")
            .needed(&LoadDescription::body, body_name(), "coupler");
        m.key("at", "Where the force acts, in the drawn position; required with a force.")
            .may(&LoadDescription::at, point());
        m.key("force", "The force on the body; its components are along the world axes as drawn.")
            .may(&LoadDescription::force, force_vector());
        m.key("couple",
              "The couple on the body: in the plane one value, counterclockwise if positive; in "
              "space a vector [Tx, Ty, Tz].")
            .may(&LoadDescription::couple, couple(), "5 N*m");
        m.key("frame", "Whether force and couple keep their direction or turn with the body.")
            .may(&LoadDescription::frame,
                 choice_of<LoadFrame>(
                     {{"world", "they keep their directions in the world, as a weight does"},
                      {"body",
                       "they turn with the body from its drawn position, as a thrust, a pressure "
                       "on a flap or a cutting force does"}}),
                 "body")
            .usual("world");
        declare_rules(m);
      });
  return mapping;
}

}  // namespace

Form<std::vector<LoadDescription>> loads() {
  auto form = named(&LoadDescription::name,
                    load().form(),
                    {.item = "a load", .name_definition = "new_name"},
                    "load '{0}'");
  form.shape.definition = "loads";
  form.shape.meaning = "External forces and couples on bodies, by name.";
  form.shape.examples = {"{wind: {body: coupler, at: [3, 4], force: [0, -250 N]}}"};
  return form;
}

}  // namespace kinestat
