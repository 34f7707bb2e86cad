// The section `bodies`.
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "format/sections/sections.hpp"
#include "forms/alternatives.hpp"
#include "forms/collections.hpp"
#include "forms/mapping.hpp"
#include "forms/number_forms.hpp"
#include "forms/value_forms.hpp"

namespace kinestat {

namespace {

constexpr const char* kInertiaHint =
    "about the centre of mass, in the plane write one number, inertia: 0.002; in space the three "
    "moments about axes parallel to x, y, z, [0.002, 0.002, 0.003], or the three rows of the "
    "tensor";

Form<InertiaDescription> planar_inertia() {
  return converted<InertiaDescription>(
      moment_of_inertia(),
      [](Value value) {
        return InertiaDescription{.entries = {std::move(value)}, .axis = {}, .where = {}};
      },
      [](const InertiaDescription& one) { return one.entries.front(); });
}

using Rows = std::vector<std::vector<Value>>;

// Three moments, or three rows of three.
Form<InertiaDescription> tensor() {
  return converted<InertiaDescription>(
      list_of(one_or_more(product_of_inertia()), "row {0} of {1}", kInertiaHint, {3, 3}),
      [](Rows rows) {
        InertiaDescription result;
        for (std::vector<Value>& row : rows) {
          std::ranges::move(row, std::back_inserter(result.entries));
        }
        return result;
      },
      [](const InertiaDescription& one) {
        const std::size_t width = one.entries.size() / 3;
        Rows rows;
        for (std::size_t i = 0; i < 3; ++i) {
          const auto first = one.entries.begin() + static_cast<std::ptrdiff_t>(i * width);
          rows.emplace_back(first, first + static_cast<std::ptrdiff_t>(width));
        }
        return rows;
      });
}

const Mapping<InertiaDescription>& polar_inertia() {
  static const Mapping<InertiaDescription> mapping(
      "polar_inertia",
      "The moment of inertia of a rotor, which turns about this axis alone.",
      "{polar: 0.05, axis: z}",
      [](auto& m) {
        m.key("polar", "The moment of inertia about the axis.")
            .needed(&InertiaDescription::entries,
                    converted<std::vector<Value>>(
                        moment_of_inertia(),
                        [](Value value) { return std::vector{std::move(value)}; },
                        [](const std::vector<Value>& one) { return one.front(); }),
                    "0.05");
        m.key("axis", "Its direction, through the centre of mass.")
            .needed(&InertiaDescription::axis, turning_axis(), "z");
      });
  return mapping;
}

bool is_whole(const YamlNode& node, Space space) {
  const auto is_row = [](const YamlNode& item) {
    return item.kind == YamlKind::sequence && item.items.size() == 3;
  };
  const auto is_list = [](const YamlNode& item) { return item.kind == YamlKind::sequence; };
  switch (node.kind) {
    case YamlKind::sequence:
      return space == Space::spatial && node.items.size() == 3 &&
             (std::ranges::all_of(node.items, is_row) || std::ranges::none_of(node.items, is_list));
    case YamlKind::mapping:
      return true;
    default:
      return space == Space::planar;
  }
}

Form<InertiaDescription> inertia() {
  auto form = by_shape<InertiaDescription>(
      {planar_inertia(), tensor(), polar_inertia().form()}, [](const InertiaDescription& one) {
        return one.axis ? std::size_t{2} : std::size_t{one.entries.size() == 1 ? 0U : 1U};
      });
  form.read = [read = form.read](const FileValue& value) -> std::optional<InertiaDescription> {
    if (value.space && !is_whole(value.node, *value.space)) {
      value.found.error("E0304",
                        value.node.where,
                        fmt::format("{} is not written like this in {} space",
                                    value.what,
                                    *value.space == Space::planar ? "planar" : "three-dimensional"),
                        kInertiaHint);
      return std::nullopt;
    }
    auto result = read(value);
    if (result) {
      result->where = value.node.where;
    }
    return result;
  };
  return form;
}

Form<std::vector<InertiaDescription>> inertia_if_any() {
  return converted<std::vector<InertiaDescription>>(
      inertia(),
      [](InertiaDescription one) { return std::vector{std::move(one)}; },
      [](const std::vector<InertiaDescription>& one) { return one.front(); });
}

const Mapping<BodyDescription>& body() {
  static const Mapping<BodyDescription> mapping(
      "body",
      "A moving body; its value may be left empty.",
      "{reference: [0, 17, 0], mass: 2.5 kg}",
      [](auto& m) {
        m.may_be_empty();
        m.key("reference",
              "The point whose absolute velocity is reported, in the drawn position; default: the "
              "point of the body's first coupling.")
            .may(&BodyDescription::reference, point());
        m.key("mass", "Mass, for gravity and inertia forces; default: none.")
            .may(&BodyDescription::mass, mass(), "2.5 kg");
        m.key("centre_of_mass",
              "The centre of mass in the drawn position, where gravity acts; default: of a gear, "
              "on its axis.")
            .may(&BodyDescription::centre_of_mass, point());
        m.key("inertia",
              "Inertia about the centre of mass: one number in the plane; in space the moments "
              "about axes parallel to x, y and z as drawn, the three rows of the tensor (Jxy = "
              "-integral of x*y), or {polar: NUMBER, axis: z} for a rotor. It acts in cases with "
              "'acceleration'; default: none.")
            .may(&BodyDescription::inertia, inertia_if_any, "0.002")
            .example("{polar: 0.05, axis: z}");
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
