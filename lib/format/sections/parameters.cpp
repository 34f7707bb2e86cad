// The section `parameters`.
#include "expression/parameters.hpp"

#include "format/sections/expression_names.hpp"
#include "format/sections/sections.hpp"
#include "forms/alternatives.hpp"
#include "forms/number_forms.hpp"

namespace kinestat {

namespace {

const Mapping<ParameterDescription>& free_parameter() {
  static const Mapping<ParameterDescription> mapping("", "", "{free: 0}", [](auto& m) {
    m.key("free", "The value that numbers use.")
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
      "numbers use the value, and the report also gives the results as functions of it.";
  form.shape.examples = {"19", "20 deg", "(N1 + N5)/2*module", "{free: 0}"};
  return form;
}

}  // namespace

Form<std::vector<ParameterDescription>> parameters() {
  auto form = named_in_expressions(named(&ParameterDescription::name,
                                         parameter(),
                                         {.item = "a parameter",
                                          .elements = "names to values",
                                          .name_definition = "parameter_name"},
                                         "parameter '{0}'"),
                                   "parameter");
  form.write = [write = form.write](const std::vector<ParameterDescription>& parameters) {
    FileText text = write(parameters);
    text.in_lines = true;
    return text;
  };
  return form;
}

}  // namespace kinestat
