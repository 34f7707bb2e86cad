#include "expression/parameters.hpp"

#include "expression/parameters/parameter_values.hpp"

namespace kinestat {

template class BasicParameterTable<double>;

template ParameterValues evaluate_parameters<double>(std::span<const Parameter>);

std::vector<int> evaluation_order(std::span<const Parameter> parameters) {
  const ParameterTable table(parameters);
  return find_order(parameters, [&](std::string_view name) { return table.index_of(name); }).order;
}

}  // namespace kinestat
