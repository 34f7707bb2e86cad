#include "description/mechanism_description.hpp"

#include <algorithm>

namespace kinestat {

std::vector<Parameter> parameters_of(const MechanismDescription& description) {
  std::vector<Parameter> parameters;
  parameters.reserve(description.parameters.size());
  for (const ParameterDescription& parameter : description.parameters) {
    parameters.push_back({.name = parameter.name.text,
                          .value = parameter.value.expression,
                          .name_where = parameter.name.where,
                          .value_where = parameter.value.where});
  }
  return parameters;
}

bool has_free_parameters(const MechanismDescription& description) {
  return std::ranges::any_of(description.parameters, &ParameterDescription::is_free);
}

}  // namespace kinestat
