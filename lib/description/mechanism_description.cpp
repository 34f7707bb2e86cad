#include "description/mechanism_description.hpp"

#include <algorithm>

namespace kinestat {

std::vector<Parameter> parameters_of(const MechanismDescription& description) {
  std::vector<Parameter> parameters;
  parameters.reserve(description.parameters.size());
  for (const ParameterDescription& parameter : description.parameters) {
    parameters.push_back({.name = parameter.name.text,
                          .value = parameter.value.expression,
                          .name_where = parameter.name.where});
  }
  return parameters;
}

int limit_sense(const std::optional<Value>& end, const MechanismDescription& description) {
  const std::string text = end ? end->expression.text() : "";
  const int sense = text == kLimitWord ? 1 : text == kLimitBackwards ? -1 : 0;
  const bool is_parameter = sense != 0 && std::ranges::any_of(description.parameters,
                                                              [](const ParameterDescription& one) {
                                                                return one.name.text == kLimitWord;
                                                              });
  return is_parameter ? 0 : sense;
}

bool has_free_parameters(const MechanismDescription& description) {
  return std::ranges::any_of(description.parameters, &ParameterDescription::is_free);
}

}  // namespace kinestat
