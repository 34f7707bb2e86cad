// The functions of evaluate.hpp and parameters.hpp for the number type Precise.
#include "expression/evaluate/evaluate_as.hpp"
#include "expression/evaluate/precise_carrier.hpp"
#include "expression/parameters/parameter_values.hpp"

namespace kinestat {

using PreciseQuantity = BasicQuantity<Precise>;
using PreciseLookup = BasicNameLookup<Precise>;

template std::variant<PreciseQuantity, ExpressionError> evaluate<Precise>(
    const Expression&, const PreciseLookup&, std::span<const std::string>);

template std::variant<Precise, ExpressionError> fit<Precise>(const PreciseQuantity&,
                                                             QuantityKind,
                                                             const FileUnits&);

template std::variant<Precise, ExpressionError> evaluate_as<Precise>(QuantityKind,
                                                                     const Expression&,
                                                                     const FileUnits&,
                                                                     const PreciseLookup&,
                                                                     std::span<const std::string>);

template class BasicParameterTable<Precise>;

template BasicParameterValues<Precise> evaluate_parameters<Precise>(std::span<const Parameter>);

}  // namespace kinestat
