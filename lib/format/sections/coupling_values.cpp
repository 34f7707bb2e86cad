#include "format/sections/coupling_values.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "forms/alternatives.hpp"
#include "forms/mapping.hpp"
#include "forms/number_forms.hpp"
#include "forms/value_forms.hpp"
#include "forms/variants.hpp"
#include "io/cut_value.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

namespace {

using PointOfBody = std::pair<Name, PointDescription>;

const SharedList<std::string_view>& letters() {
  static const SharedList<std::string_view> names = {"x", "y", "z", "X", "Y", "Z"};
  return names;
}

// {x: 1, y: 2}, as other programs write points.
bool has_letter_keys(const YamlNode& node) {
  return !node.entries.empty() && std::ranges::all_of(node.entries, [](const YamlEntry& entry) {
    return std::ranges::find(letters(), entry.key) != letters().end();
  });
}

bool check_points_of_bodies(const FileValue& value) {
  const std::size_t count = value.node.entries.size();
  const bool has_letters = has_letter_keys(value.node);
  if (!has_letters && count == 2) {
    return true;
  }
  value.found.error(
      "E0304",
      value.node.where,
      has_letters
          ? fmt::format("{} is a mapping of coordinates", value.what)
          : fmt::format("{} is given for {} bod{}", value.what, count, count == 1 ? "y" : "ies"),
      fmt::format(
          "write {0}, or {{TAIL: {0}, HEAD: {0}}} for the point as drawn on each of the two bodies",
          sketch_of(point().shape, value.space.value())));
  return false;
}

// A coupling point of which one member is given.
template <class Member, class Given>
Form<CouplingPoint> point_given_by(Member CouplingPoint::*member, const Form<Given>& form) {
  return converted<CouplingPoint>(
      form,
      [member](Given given) {
        CouplingPoint result;
        result.*member = std::move(given);
        return result;
      },
      [member](const CouplingPoint& one) { return *present(one.*member, Member(), true); });
}

// A length, or the word flat.
Form<std::optional<Value>> contact_radius() {
  const Form<Value> number = called(length(), "the radius of {0}");
  FormShape shape = number.shape;
  shape.definition = {};
  shape.words = {{"flat", "a plane"}};
  return {.shape = std::move(shape),
          .read = [number](const FileValue& value) -> std::optional<std::optional<Value>> {
            if (value.node.kind == YamlKind::scalar && value.node.text == "flat") {
              return std::optional<Value>();
            }
            auto one = number.read(value);
            return one ? std::optional(std::optional(*std::move(one))) : std::nullopt;
          },
          .write =
              [number](const std::optional<Value>& one) {
                return one ? number.write(*one) : single_text("flat");
              }};
}

void refuse_ends(const FileValue& value) {
  const YamlNode& node = value.node;
  if (report_loose_end(node, value.found)) {
    return;
  }
  const std::size_t count = node.items.size();
  const std::string listed = count == 1 ? with_commas(node.items.front()) : with_commas(node);
  value.found.error(
      "E0304",
      node.where,
      node.kind == YamlKind::sequence ? fmt::format("{} joins {} bod{}, it must join two",
                                                    *value.owner,
                                                    count,
                                                    count == 1 ? "y" : "ies")
                                      : fmt::format("{} must join two bodies", *value.owner),
      fmt::format("write bodies: [{}]{}; motions are those of the head relative to the tail",
                  listed.empty() ? "tail, head" : listed,
                  listed.empty() ? "" : ": a comma between the names"));
}

void declare_line(Mapping<ScrewDescription>& m) {
  m.key("at",
        "A point on the axis of the rotation or on the line of the force; default the origin.")
      .may(&ScrewDescription::at, called(point(), "the point of a screw"));
  m.key("pitch", "Pitch of the screw, the length per radian, right-handed if positive; default 0.")
      .may(&ScrewDescription::pitch, called(pitch(), "the pitch"), "2 mm/rad")
      .usual("0");
}

const Mapping<ScrewDescription>& rotation() {
  static const Mapping<ScrewDescription> mapping(
      "", "a turn about a line", "{rotation: z, at: [0, 0, 0]}", [](auto& m) {
        m.key("rotation",
              "Axis of a rotation: x, y, z, -x, -y, -z or a vector [ax, ay, az], also in the "
              "plane.")
            .needed(&ScrewDescription::direction, called(turning_axis(), "the {1}"), "z")
            .selects(&ScrewDescription::kind, ScrewWord::rotation);
        declare_line(m);
      });
  return mapping;
}

const Mapping<ScrewDescription>& translation() {
  static const Mapping<ScrewDescription> mapping("", "a slide", "{translation: x}", [](auto& m) {
    m.key("translation", "Direction of a translation.")
        .needed(&ScrewDescription::direction, called(direction(), "the {1}"), "x")
        .selects(&ScrewDescription::kind, ScrewWord::translation);
  });
  return mapping;
}

const Mapping<ScrewDescription>& force_along() {
  static const Mapping<ScrewDescription> mapping(
      "", "a force along a line", "{force: y, at: [0, 0, 0]}", [](auto& m) {
        m.key("force", "Line of action of a force.")
            .needed(&ScrewDescription::direction, called(direction(), "the {1}"), "y")
            .selects(&ScrewDescription::kind, ScrewWord::force);
        declare_line(m);
      });
  return mapping;
}

const Mapping<ScrewDescription>& couple_about() {
  static const Mapping<ScrewDescription> mapping("", "a couple", "{couple: z}", [](auto& m) {
    m.key("couple",
          "Axis of a couple: x, y, z, -x, -y, -z or a vector [ax, ay, az], also in the plane.")
        .needed(&ScrewDescription::direction, called(turning_axis(), "the {1}"), "z")
        .selects(&ScrewDescription::kind, ScrewWord::couple);
  });
  return mapping;
}

// A kind of screw in the schema, and how it is written.
struct ScrewTexts {
  const char* definition;
  const char* meaning;
  const char* example;
  const char* hint;
};

constexpr ScrewTexts kMotionScrew = {
    .definition = "motion_screw",
    .meaning =
        "A motion given directly as a screw: a rotation or a translation; a rotation has an axis "
        "through 'at' and may have a pitch.",
    .example = "{rotation: [0, 0, 1], at: [0, 0, 0], pitch: 2 mm/rad}",
    .hint = "write {rotation: z, at: [x, y, z]} or {translation: x}; a rotation may have a pitch"};

constexpr ScrewTexts kActionScrew = {
    .definition = "action_screw",
    .meaning =
        "An action given directly as a screw: a force or a couple; a force has a line "
        "through 'at' and may have a pitch.",
    .example = "{force: [0, 1, 0], at: [0, 0, 0]}",
    .hint = "write {force: y, at: [x, y, z]} or {couple: z}; a force may have a pitch"};

Form<ScrewDescription> one_screw_of(const Mapping<ScrewDescription>& first,
                                    const Mapping<ScrewDescription>& second,
                                    const ScrewTexts& texts) {
  const auto is_second = [](const ScrewDescription& one) {
    return one.kind == ScrewWord::translation || one.kind == ScrewWord::couple;
  };
  auto form = only_one_of<ScrewDescription>(
      {&first, &second},
      fmt::format("{{}} needs one of {} and {}",
                  first.shape().keys.front().key,
                  second.shape().keys.front().key),
      texts.hint,
      [is_second](const ScrewDescription& one) { return is_second(one) ? 1U : 0U; });
  form.shape.definition = texts.definition;
  form.shape.meaning = texts.meaning;
  form.shape.examples = {texts.example};
  return form;
}

Form<std::vector<ScrewDescription>> screws_of(const Form<ScrewDescription>& one,
                                              const ScrewTexts& texts) {
  const auto is_mapping = [](const YamlNode& node) { return node.kind == YamlKind::mapping; };
  const auto screw = only_if(one, is_mapping, "{} must be a mapping of keys to values", texts.hint);
  return only_if(
      list_of(called(screw, "a screw of {0}"), "", "", {.least = 0}),
      [](const YamlNode& node) { return node.kind == YamlKind::sequence; },
      "{} needs a list of screws",
      texts.hint);
}

}  // namespace

Form<std::vector<PointOfBody>> points_of_bodies() {
  auto form = values_by_name(
      &PointOfBody::first,
      &PointOfBody::second,
      point(),
      {.name_definition = "name",
       .foreign = {.names = letters(), .instead = "Write a point as [x, y] or [x, y, z]."},
       .least = 2,
       .most = 2},
      "{1}");
  form.read = [read =
                   form.read](const FileValue& value) -> std::optional<std::vector<PointOfBody>> {
    return check_points_of_bodies(value) ? read(value) : std::nullopt;
  };
  return form;
}

Form<Flank> flank_of_teeth() {
  return choice_of<Flank>(
      {{"loaded", "in each case the one on which the torque presses, as with real teeth"},
       {"fixed", "always the same one, as in sources with one line of action"}});
}

bool is_pair(const YamlNode& node) {
  return node.kind == YamlKind::sequence && node.items.size() == 2;
}

Form<CouplingPoint> coupling_point() {
  auto form = by_shape<CouplingPoint>(
      {point_given_by(&CouplingPoint::point, point()),
       point_given_by(&CouplingPoint::of_bodies, points_of_bodies()),
       point_given_by(&CouplingPoint::along_axis, length())},
      [](const CouplingPoint& one) {
        return one.point ? std::size_t{0} : one.of_bodies.empty() ? std::size_t{2} : std::size_t{1};
      });
  form.shape.definition = "coupling_point";
  form.shape.meaning =
      "Where the coupling is, in the drawn position: a point [x, y] in the plane or [x, y, z] in "
      "space, lengths in the file's unit. {TAIL: point, HEAD: point} gives it as drawn on each of "
      "the two bodies; the finite motion first closes any difference. If 'gears' places the "
      "bodies, one number gives the position along their axis. Without a point, only mobility is "
      "counted.";
  form.shape.examples = {"[6, 5]", "[6, 5, 0]", "{crank: [1, 3], coupler: [1.02, 3]}"};
  form.read = [read = form.read](const FileValue& value) {
    auto one = read(value);
    if (one) {
      one->where = value.node.where;
    }
    return one;
  };
  return form;
}

Form<std::vector<Name>> coupling_ends() {
  auto form = list_of(body_name(), "", "", {.least = 2, .most = 2});
  form.read = [](const FileValue& value) -> std::optional<std::vector<Name>> {
    if (!is_pair(value.node)) {
      refuse_ends(value);
      return std::nullopt;
    }
    auto tail = read_reference(value.node.items[0], "the tail", value.found);
    auto head = read_reference(value.node.items[1], "the head", value.found);
    return tail && head ? std::optional(std::vector{*std::move(tail), *std::move(head)})
                        : std::nullopt;
  };
  return form;
}

Form<std::vector<std::optional<Value>>> contact_radii() {
  return only_if(list_of(contact_radius(), "", "", {.least = 2, .most = 2}),
                 is_pair,
                 "{} must be two, of the tail and of the head",
                 "write for example radii: [31, 10], or radii: [31, flat]");
}

Form<ScrewDescription> motion_screw() {
  return one_screw_of(rotation(), translation(), kMotionScrew);
}

Form<std::vector<ScrewDescription>> motion_screws() {
  return screws_of(motion_screw(), kMotionScrew);
}

Form<std::vector<ScrewDescription>> action_screws() {
  return screws_of(one_screw_of(force_along(), couple_about(), kActionScrew), kActionScrew);
}

Form<std::vector<StiffnessDescription>> stiffness_of_actions() {
  return values_by_name(&StiffnessDescription::action,
                        &StiffnessDescription::value,
                        stiffness(),
                        {.elements = "actions to values", .name_definition = "name"},
                        "'{0}'");
}

}  // namespace kinestat
