#include "format/value_forms.hpp"

#include "core/utf8.hpp"
#include "format/numbers.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

namespace {

Form<Name> reference(FormShape shape) {
  return {.shape = std::move(shape),
          .read =
              [](const FileValue& value) {
                return read_reference(value.node, value.what, value.found);
              },
          .write = [](const Name& name) { return name.text; }};
}

}  // namespace

Form<Name> name_of(std::string_view remark) {
  return reference({.kind = FormKind::name, .definition = "name", .remark = std::string(remark)});
}

Form<Name> body_name() {
  return reference({.kind = FormKind::name,
                    .definition = "body_name",
                    .remark = "one of 'bodies' or the ground"});
}

Form<Name> target() {
  return reference({.kind = FormKind::name, .definition = "target"});
}

Form<Name> label() {
  Form<Name> form = reference({.kind = FormKind::text, .definition = "label"});
  form.write = [](const Name& name) { return in_quotes(name.text); };
  return form;
}

Form<PointDescription> point() {
  return {.shape = {.kind = FormKind::vector,
                    .definition = "point",
                    .meaning = "A point in the drawn position: [x, y] in the plane, [x, y, z] in "
                               "space; lengths in the file's unit.",
                    .examples = {"[6, 5]", "[ground_length, 0, 25 mm]"},
                    .items = {length().shape}},
          .read =
              [](const FileValue& value) {
                return read_point(value.node, value.what, value.space.value(), value.found);
              },
          .write = [](const PointDescription& one) { return text_of(one.coordinates); }};
}

Form<bool> flag() {
  return {.shape = {.kind = FormKind::flag},
          .read = [](const FileValue& v) { return read_bool(v.node, v.what, v.found); },
          .write = [](bool is_set) { return is_set ? "true" : "false"; }};
}

std::string in_quotes(std::string_view text) {
  std::string result = "\"";
  for (const char c : printable(text)) {
    result += c == '"' || c == '\\' ? std::string{'\\', c} : std::string(1, c);
  }
  return result + "\"";
}

std::string text_of(const std::vector<Value>& values) {
  std::vector<std::string> texts;
  for (const Value& value : values) {
    texts.push_back(value.expression.text());
  }
  return in_brackets(texts);
}

std::optional<std::size_t> read_word_of(const FileValue& value, const std::vector<Word>& words) {
  std::vector<std::string> texts;
  for (const Word& word : words) {
    texts.push_back(word.text);
  }
  return read_word(value.node, value.what, texts, value.found);
}

}  // namespace kinestat
