#include "format/sections/input_values.hpp"

#include "forms/alternatives.hpp"
#include "forms/collections.hpp"
#include "forms/value_forms.hpp"

namespace kinestat {

Form<std::vector<InputValue>> values_for(std::string_view elements, const Form<Value>& number) {
  const auto for_all = converted<std::vector<InputValue>>(
      number,
      [](Value value) {
        return std::vector{InputValue{.target = std::nullopt, .value = std::move(value)}};
      },
      [](const std::vector<InputValue>& values) { return values.front().value; });
  const auto for_each = values_by_name(&InputValue::target,
                                       &InputValue::value,
                                       number,
                                       {.elements = elements, .name_definition = "name"},
                                       "'{2}' of '{0}'");
  return by_shape<std::vector<InputValue>>(
      {for_all, for_each}, [](const std::vector<InputValue>& values) {
        return values.front().target ? std::size_t{1} : std::size_t{0};
      });
}

Form<std::vector<InputValue>> input_values(const Form<Value>& number) {
  return values_for("inputs to values", number);
}

}  // namespace kinestat
