// The section `parameters`.
#include "expression/parameters.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "expression/functions.hpp"
#include "format/alternatives.hpp"
#include "format/number_forms.hpp"
#include "format/sections/sections.hpp"
#include "io/value_reader.hpp"

namespace kinestat {

namespace {

// What else in an expression has this name.
std::string_view meaning_of(std::string_view reserved) {
  if (find_unit(reserved) != nullptr) {
    return "a unit";
  }
  if (find_function(reserved) != nullptr) {
    return "a function";
  }
  return is_condition_word(reserved) ? "a word of conditions" : "a constant";
}

void check_parameter_name(const Name& name, Diagnostics& found) {
  if (is_reserved_name(name.text)) {
    found.error(
        "E0306",
        name.where,
        fmt::format(
            "a parameter cannot be named '{}', which is {}", name.text, meaning_of(name.text)),
        fmt::format("call it '{}_1', or by a longer word", name.text));
  } else if (name.text.find('-') != std::string::npos) {
    std::string better = name.text;
    std::ranges::replace(better, '-', '_');
    found.error("E0306",
                name.where,
                fmt::format("parameter '{}' would be read as a difference", name.text),
                fmt::format("call it '{}'", better));
  } else {
    check_name(name, "a parameter", found);
  }
}

const Mapping<ParameterDescription>& free_parameter() {
  static const Mapping<ParameterDescription> mapping("", "", "{free: 0}", [](auto& m) {
    m.key("free", "The value that is used in numbers.")
        .needed(&ParameterDescription::value, any_number(), "0")
        .selects(&ParameterDescription::is_free, true)
        .add_hint("'free: VALUE', the value that is used in numbers");
  });
  return mapping;
}

// A number or expression, or {free: value}.
Form<ParameterDescription> parameter() {
  const auto fixed = converted<ParameterDescription>(
      any_number(),
      [](Value value) {
        ParameterDescription parameter;
        parameter.value = std::move(value);
        return parameter;
      },
      [](const ParameterDescription& one) { return one.value; });
  auto form = by_shape<ParameterDescription>({fixed, free_parameter().form()},
                                             [](const ParameterDescription& one) {
                                               return one.is_free ? std::size_t{1} : std::size_t{0};
                                             });
  form.shape.definition = "parameter";
  form.shape.meaning =
      "A number or an expression of other parameters, in any order. {free: VALUE} leaves it open: "
      "the value is used in numbers, and how the results depend on it is reported as well.";
  form.shape.examples = {"19", "20 deg", "(N1 + N5)/2*module", "{free: 0}"};
  return form;
}

}  // namespace

Form<std::vector<ParameterDescription>> parameters() {
  auto form = named(
      &ParameterDescription::name,
      parameter(),
      {.item = "a parameter", .elements = "names to values", .name_definition = "parameter_name"},
      "parameter '{0}'");
  form.read = [read = form.read](const FileValue& value) {
    auto parameters = read(value);
    const int errors_before = value.found.error_count();
    for (const YamlEntry& entry : value.node.entries) {
      check_parameter_name({.text = entry.key, .where = entry.key_where}, value.found);
    }
    return value.found.error_count() == errors_before ? parameters : std::nullopt;
  };
  form.write = [write = form.write](const std::vector<ParameterDescription>& parameters) {
    FileText text = write(parameters);
    text.in_lines = true;
    return text;
  };
  return form;
}

}  // namespace kinestat
