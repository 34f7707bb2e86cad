// The functions of evaluate.hpp and parameters.hpp for the number type Typed.
#include "expression/evaluate/evaluate_as.hpp"
#include "expression/evaluate/typed_carrier.hpp"
#include "expression/parameters/parameter_values.hpp"

namespace kinestat {

using TypedQuantity = BasicQuantity<Typed>;
using TypedLookup = BasicNameLookup<Typed>;

template std::variant<TypedQuantity, ExpressionError> evaluate<Typed>(const Expression&,
                                                                      const TypedLookup&,
                                                                      std::span<const std::string>);

template std::variant<Typed, ExpressionError> fit<Typed>(const TypedQuantity&,
                                                         QuantityKind,
                                                         const FileUnits&);

template std::variant<Typed, ExpressionError> evaluate_as<Typed>(QuantityKind,
                                                                 const Expression&,
                                                                 const FileUnits&,
                                                                 const TypedLookup&,
                                                                 std::span<const std::string>);

template class BasicParameterTable<Typed>;

template BasicParameterValues<Typed> evaluate_parameters<Typed>(std::span<const Parameter>);

}  // namespace kinestat
