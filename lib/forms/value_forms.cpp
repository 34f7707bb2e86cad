#include "forms/value_forms.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/utf8.hpp"
#include "expression/functions.hpp"
#include "forms/number_forms.hpp"
#include "io/cut_value.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

namespace {

constexpr const char* kNamePattern = "^[A-Za-z_][A-Za-z0-9_-]*$";
constexpr const char* kNameText =
    "A name is letters, digits, '_' and '-', and begins with a letter or '_'.";

// Upper and lower case differ.
std::string parameter_pattern() {
  return fmt::format("^(?!({})$)[A-Za-z_][A-Za-z0-9_]*$", fmt::join(reserved_names(), "|"));
}

const std::vector<FormShape>& text_shapes() {
  static const std::string parameter = parameter_pattern();
  static const std::vector<FormShape> shapes = {
      {.kind = FormKind::text,
       .definition = "text",
       .meaning =
           "Free text. Text that looks like a number needs no quotes; true, false and null do."},
      {.kind = FormKind::text,
       .definition = "label",
       .meaning = "Free text that names a case or a gear."},
      {.kind = FormKind::name,
       .definition = "name",
       .meaning = "A name that this file declares.",
       .pattern = kNamePattern,
       .pattern_text = kNameText},
      {.kind = FormKind::name,
       .definition = "new_name",
       .meaning = "A name of your choice: letters, digits, '_' and '-', beginning with a letter or "
                  "'_'.",
       .pattern = kNamePattern,
       .pattern_text = kNameText},
      {.kind = FormKind::name,
       .definition = "body_name",
       .meaning = "Name of a body of 'bodies', or the ground.",
       .examples = {"crank"},
       .remark = "one of 'bodies' or the ground",
       .pattern = kNamePattern,
       .pattern_text = kNameText},
      {.kind = FormKind::name,
       .definition = "coupling_name",
       .meaning = "Name of a coupling of this file.",
       .examples = {"a"},
       .remark = "the coupling that it drives",
       .pattern = kNamePattern,
       .pattern_text = kNameText},
      {.kind = FormKind::name,
       .definition = "target",
       .meaning = "An actuator, or COUPLING.FREEDOM, or COUPLING.ACTION.",
       .pattern = "^[A-Za-z_][A-Za-z0-9_-]*(\\.[A-Za-z0-9_-]+)?$",
       .pattern_text = "Write the name of an actuator, or of a coupling with its freedom or "
                       "action, such as d.wz or c.Rx."},
      {.kind = FormKind::name,
       .definition = "power_end",
       .meaning = "An actuator, or a load; gravity.BODY is the weight of a body.",
       .examples = {"drive"},
       .remark = "an actuator or a load",
       .pattern = "^[A-Za-z_][A-Za-z0-9_-]*(\\.[A-Za-z0-9_-]+)?$",
       .pattern_text = "Write the name of an actuator or a load, such as gravity.hook."},
      {.kind = FormKind::name,
       .definition = "column_name",
       .meaning = "A word, an actuator, COUPLING.FREEDOM, COUPLING.ACTION, or a column as tables "
                  "call it: NAME/QUANTITY.",
       .pattern = "^[A-Za-z_][A-Za-z0-9_-]*([./][A-Za-z0-9_-]+)*$",
       .pattern_text = "Write one of the words, the name of an actuator, of a coupling with its "
                       "freedom or action, such as d.wz or c.Rx, or a column such as "
                       "motor/action or pen/at/x."},
      {.kind = FormKind::name,
       .definition = "quantity",
       .meaning = "A quantity in a row of a sweep; for a whole motion, a column with dots and a "
                  "statistic; or the place of a number in the report of a case.",
       .pattern = "^[A-Za-z_][A-Za-z0-9_-]*([./][A-Za-z0-9_-]+)*$",
       .pattern_text = "Write ratio, an actuator, a freedom or an action such as d.wz or c.Rx, "
                       "a figure of a motion such as d.vx.position.range, or a number of a case "
                       "such as power/input."},
      {.kind = FormKind::name,
       .definition = "parameter_name",
       .meaning = "A name of your choice: letters, digits and '_', beginning with a letter or '_'; "
                  "not that of a unit or a function, pi, and, or, not.",
       .pattern = parameter,
       .pattern_text = "The name of a parameter or curve is letters, digits and '_', begins with a "
                       "letter or '_', and is not that of a unit (m, N, g …), a function (sin, "
                       "min …), pi, and, or, not."}};
  return shapes;
}

Form<Name> reference(const FormShape& shape) {
  return {.shape = shape,
          .read =
              [is_name = shape.kind == FormKind::name](const FileValue& value) {
                return is_name && report_loose_end(value.node, value.found)
                           ? std::nullopt
                           : read_reference(value.node, value.what, value.found);
              },
          .write = [](const Name& name) { return single_text(name.text); }};
}

FormShape axis_words() {
  return {.kind = FormKind::word,
          .words = {{"x", "along +x"},
                    {"y", "along +y"},
                    {"z", "along +z; in the plane, perpendicular to it"},
                    {"-x",
                     "along -x; freedoms and actions along it are named without a letter: w, v, R, "
                     "T"},
                    {"-y",
                     "along -y; freedoms and actions along it are named without a letter: w, v, R, "
                     "T"},
                    {"-z",
                     "along -z; freedoms and actions along it are named without a letter: w, v, R, "
                     "T"}}};
}

// Of the components that the space has, by default that of the file.
Form<AxisDescription> axis_of(FormShape shape, std::optional<Space> space) {
  shape.kind = FormKind::by_shape;
  return {.shape = std::move(shape),
          .read =
              [space](const FileValue& value) {
                return read_axis(
                    value.node, value.what, space ? *space : value.space.value(), value.found);
              },
          .write =
              [](const AxisDescription& one) {
                return one.keyword == 0
                           ? text_of(one.components)
                           : single_text(std::string(one.sign < 0.0 ? "-" : "") + one.keyword);
              }};
}

}  // namespace

const FormShape& text_shape(std::string_view definition) {
  const auto at = std::ranges::find(text_shapes(), definition, &FormShape::definition);
  KINESTAT_EXPECTS(at != text_shapes().end());
  return *at;
}

Form<Name> name_of(std::string_view remark) {
  Form<Name> form = reference(text_shape("name"));
  form.shape.remark = remark;
  return form;
}

Form<Name> body_name() {
  return reference(text_shape("body_name"));
}

namespace {

Form<Name> made_new(Form<Name> form, std::string what) {
  form.read = [what = std::move(what),
               read = form.read](const FileValue& value) -> std::optional<Name> {
    auto name = read(value);
    return name && check_name(*name, what, value.found) ? name : std::nullopt;
  };
  return form;
}

}  // namespace

Form<Name> new_body_name(std::string what) {
  return made_new(body_name(), std::move(what));
}

Form<Name> new_name(std::string what) {
  return made_new(reference(text_shape("name")), std::move(what));
}

Form<Name> coupling_name() {
  return reference(text_shape("coupling_name"));
}

Form<Name> free_name() {
  return reference({.kind = FormKind::literal});
}

Form<Name> target() {
  return reference(text_shape("target"));
}

Form<Name> power_end() {
  return reference(text_shape("power_end"));
}

Form<Name> column_name() {
  return reference(text_shape("column_name"));
}

Form<Name> quantity() {
  return reference(text_shape("quantity"));
}

Form<Name> label() {
  Form<Name> form = reference(text_shape("label"));
  form.write = [](const Name& name) { return single_text(in_quotes(name.text)); };
  return form;
}

Form<PointDescription> vector_of(const Form<Value>& component,
                                 std::string_view definition,
                                 std::string_view meaning,
                                 SharedList<std::string_view> examples) {
  return {.shape = {.kind = FormKind::vector,
                    .definition = definition,
                    .meaning = meaning,
                    .examples = std::move(examples),
                    .items = {component.shape}},
          .read = [](const FileValue& value) -> std::optional<PointDescription> {
            auto one = read_point(value.node, value.what, value.space.value(), value.found);
            if (one) {
              one->where = value.place;
            }
            return one;
          },
          .write = [](const PointDescription& one) { return text_of(one.coordinates); }};
}

Form<PointDescription> point() {
  return vector_of(
      length(),
      "point",
      "A point in the drawn position: [x, y] in the plane, [x, y, z] in space; lengths "
      "in the file's unit.",
      {"[6, 5]", "[ground_length, 0, 25 mm]"});
}

Form<PointDescription> point_in_plane() {
  return {.shape = {.kind = FormKind::list,
                    .definition = "point2",
                    .meaning = "A point in the plane, [x, y]; lengths in the file's unit.",
                    .examples = {"[0.424, 0.245]"},
                    .sketch = "[x, y]",
                    .least = 2,
                    .most = 2,
                    .items = {length().shape}},
          .read =
              [](const FileValue& value) {
                return read_point(value.node, value.what, Space::planar, value.found);
              },
          .write = [](const PointDescription& one) { return text_of(one.coordinates); }};
}

Form<AxisDescription> turning_axis() {
  return axis_of(
      {.definition = "axis",
       .meaning = "The axis: x, y, z, -x, -y, -z or a vector [ax, ay, az] of any "
                  "length but zero. In the plane it is z, which need not be written.",
       .examples = {"z", "[0, 0.6, 0.8]"},
       .items = {axis_words(),
                 FormShape{
                     .kind = FormKind::list, .least = 3, .most = 3, .items = {component().shape}}}},
      Space::spatial);
}

Form<AxisDescription> direction() {
  return axis_of(
      {.definition = "direction",
       .meaning = "A direction: x, y, z, -x, -y, -z or a vector of any length but zero, [ax, ay] "
                  "in the plane, [ax, ay, az] in space.",
       .examples = {"x", "[1, 0.5]", "[1, 0, 0.5]"},
       .items = {axis_words(), FormShape{.kind = FormKind::vector, .items = {component().shape}}}},
      std::nullopt);
}

Form<std::string> text() {
  return {.shape = text_shape("text"),
          .read = [](const FileValue& v) { return read_text(v.node, v.what, v.found); },
          .write = [](const std::string& one) { return single_text(in_quotes(one)); }};
}

Form<bool> flag() {
  return {.shape = {.kind = FormKind::flag},
          .read = [](const FileValue& v) { return read_bool(v.node, v.what, v.found); },
          .write = [](bool is_set) { return single_text(is_set ? "true" : "false"); }};
}

FileText text_of(const std::vector<Value>& values) {
  std::vector<FileText> texts;
  for (const Value& value : values) {
    texts.push_back(expression_text(value.expression.text()));
  }
  return list_text(std::move(texts));
}

std::optional<std::size_t> read_word_of(const FileValue& value, const SharedList<Word>& words) {
  const Word* const at = std::ranges::find(words, value.node.text, &Word::text);
  if (value.node.kind == YamlKind::scalar && at != words.end()) {
    return static_cast<std::size_t>(at - words.begin());
  }
  std::vector<std::string> texts;
  for (const Word& word : words) {
    texts.emplace_back(word.text);
  }
  complain_of_word(value.node, value.what, texts, value.found);
  return std::nullopt;
}

AnyForm any_choice_of(SharedList<Word> words,
                      void (*set)(void* object, std::size_t index),
                      std::size_t (*index_of)(const void* object)) {
  return {.shape = {.kind = FormKind::word, .words = words},
          .read =
              [words, set](const FileValue& value, void* object) {
                const auto index = read_word_of(value, words);
                if (index) {
                  set(object, *index);
                }
                return index.has_value();
              },
          .write =
              [words, index_of](const void* object) {
                return single_text(std::string(words[index_of(object)].text));
              }};
}

}  // namespace kinestat
