// The functions of evaluate.hpp and parameters.hpp for the number type Dual.
#include "expression/evaluate/dual_carrier.hpp"
#include "expression/evaluate/evaluate_as.hpp"
#include "expression/parameters/parameter_values.hpp"

namespace kinestat {

using DualQuantity = BasicQuantity<Dual>;
using DualLookup = BasicNameLookup<Dual>;

template std::variant<DualQuantity, ExpressionError> evaluate<Dual>(const Expression&,
                                                                    const DualLookup&,
                                                                    std::span<const std::string>);

template std::variant<Dual, ExpressionError> fit<Dual>(const DualQuantity&,
                                                       QuantityKind,
                                                       const FileUnits&);

template std::variant<Dual, ExpressionError> evaluate_as<Dual>(QuantityKind,
                                                               const Expression&,
                                                               const FileUnits&,
                                                               const DualLookup&,
                                                               std::span<const std::string>);

template class BasicParameterTable<Dual>;

BasicParameterValues<Dual> evaluate_parameters(std::span<const Parameter> parameters,
                                               std::span<const int> variables) {
  const auto seed = [variables](int parameter, DualQuantity& quantity) {
    const auto place = std::ranges::find(variables, parameter);
    if (place != variables.end()) {
      const auto index = static_cast<std::size_t>(place - variables.begin());
      quantity.value.derivatives.resize(variables.size(), 0.0);
      quantity.value.derivatives[index] = 1.0;
    }
  };
  return evaluate_in_order<Dual>(parameters, seed);
}

}  // namespace kinestat
