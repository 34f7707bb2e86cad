#include "expression/parameters.hpp"

#include "expression/internal/parameter_values.hpp"

namespace kinestat {

template class BasicParameterTable<double>;

template ParameterValues evaluate_parameters<double>(std::span<const Parameter>);

}  // namespace kinestat
