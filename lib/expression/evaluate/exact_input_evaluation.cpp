// The functions of evaluate.hpp and parameters.hpp for the number type ExactInput.
#include "expression/evaluate/evaluate_as.hpp"
#include "expression/evaluate/exact_input_carrier.hpp"
#include "expression/parameters/parameter_values.hpp"

namespace kinestat {

using ExactInputQuantity = BasicQuantity<ExactInput>;
using ExactInputLookup = BasicNameLookup<ExactInput>;

template std::variant<ExactInputQuantity, ExpressionError> evaluate<ExactInput>(
    const Expression&, const ExactInputLookup&, std::span<const std::string>);

template std::variant<ExactInput, ExpressionError> fit<ExactInput>(const ExactInputQuantity&,
                                                                   QuantityKind,
                                                                   const FileUnits&);

template std::variant<ExactInput, ExpressionError> evaluate_as<ExactInput>(
    QuantityKind,
    const Expression&,
    const FileUnits&,
    const ExactInputLookup&,
    std::span<const std::string>);

template class BasicParameterTable<ExactInput>;

template BasicParameterValues<ExactInput> evaluate_parameters<ExactInput>(
    std::span<const Parameter>);

}  // namespace kinestat
