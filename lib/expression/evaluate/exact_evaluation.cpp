// The functions of evaluate.hpp, condition.hpp and parameters.hpp for the number type Exact.
#include "expression/evaluate/condition_value.hpp"
#include "expression/evaluate/evaluate_as.hpp"
#include "expression/evaluate/exact_arithmetic.hpp"
#include "expression/evaluate/exact_number_traits.hpp"
#include "expression/parameters/parameter_values.hpp"

namespace kinestat {

int order_of(const Exact& a, const Exact& b) {
  const std::optional<int> exact = a.exact && b.exact ? compare(*a.exact, *b.exact) : std::nullopt;
  return exact ? *exact : order_of(a.value, b.value);
}

using ExactQuantity = BasicQuantity<Exact>;
using ExactLookup = BasicNameLookup<Exact>;

template std::variant<ExactQuantity, ExpressionError> evaluate<Exact>(const Expression&,
                                                                      const ExactLookup&,
                                                                      std::span<const std::string>);

template std::variant<Exact, ExpressionError> fit<Exact>(const ExactQuantity&,
                                                         QuantityKind,
                                                         const FileUnits&);

template std::variant<Exact, ExpressionError> evaluate_as<Exact>(QuantityKind,
                                                                 const Expression&,
                                                                 const FileUnits&,
                                                                 const ExactLookup&,
                                                                 std::span<const std::string>);

template std::variant<bool, ExpressionError> evaluate_condition<Exact>(
    const Condition&, const ExactLookup&, std::span<const std::string>);

template class BasicParameterTable<Exact>;

template BasicParameterValues<Exact> evaluate_parameters<Exact>(std::span<const Parameter>);

}  // namespace kinestat
