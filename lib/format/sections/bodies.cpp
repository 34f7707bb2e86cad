// The section `bodies`.
#include "format/alternatives.hpp"
#include "format/number_forms.hpp"
#include "format/sections/sections.hpp"
#include "format/value_forms.hpp"

namespace kinestat {

namespace {

const Mapping<BodyDescription>& body() {
  static const Mapping<BodyDescription> mapping(
      "body",
      "A moving body; its value may be left empty.",
      "{reference: [0, 17, 0], mass: 2.5 kg}",
      [](auto& m) {
        m.may_be_empty();
        m.key("reference",
              "The point whose absolute velocity is reported, in the drawn position; default the "
              "point of the body's first coupling.")
            .may(&BodyDescription::reference, point());
        m.key("mass", "Mass, on which gravity acts; default none.")
            .may(&BodyDescription::mass, mass(), "2.5 kg");
        m.key("centre_of_mass", "The centre of mass in the drawn position, where gravity acts.")
            .may(&BodyDescription::centre_of_mass, point());
        m.key("outline", "Points of the body's outline in the drawn position, for pictures.")
            .may(&BodyDescription::outline,
                 list_of(point(), "", "", {.least = 0}),
                 "[[0, 0], [2, 0], [1, 1]]");
      });
  return mapping;
}

// A name, of which the body knows no more.
Form<BodyDescription> name_alone() {
  return converted<BodyDescription>(
      new_body_name("a body"),
      [](Name name) {
        BodyDescription body;
        body.name = std::move(name);
        return body;
      },
      [](const BodyDescription& one) { return one.name; });
}

}  // namespace

Form<std::vector<BodyDescription>> bodies() {
  const auto list = list_of(name_alone(), "a body", "", {.least = 0});
  const auto mapping = named(&BodyDescription::name,
                             body().form(),
                             {.item = "a body", .name_definition = "new_name"},
                             "body '{0}'");
  auto form = by_shape<std::vector<BodyDescription>>(
      {list, mapping}, [](const std::vector<BodyDescription>&) { return std::size_t{1}; });
  form.read =
      [read = form.read](const FileValue& value) -> std::optional<std::vector<BodyDescription>> {
    if (value.node.kind != YamlKind::sequence && value.node.kind != YamlKind::mapping) {
      value.found.error("E0304",
                        value.node.where,
                        "'bodies' must be a list of names, or a mapping with attributes",
                        "write bodies: [crank, coupler, rocker]");
      return std::nullopt;
    }
    return read(value);
  };
  return form;
}

}  // namespace kinestat
