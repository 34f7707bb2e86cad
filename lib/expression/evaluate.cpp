#include "expression/evaluate.hpp"

#include "expression/evaluate/evaluate_as.hpp"

namespace kinestat {

template std::variant<Quantity, ExpressionError> evaluate<double>(const Expression&,
                                                                  const NameLookup&,
                                                                  std::span<const std::string>);

template std::variant<double, ExpressionError> fit<double>(const Quantity&,
                                                           QuantityKind,
                                                           const FileUnits&);

template std::variant<double, ExpressionError> evaluate_as<double>(QuantityKind,
                                                                   const Expression&,
                                                                   const FileUnits&,
                                                                   const NameLookup&,
                                                                   std::span<const std::string>);

}  // namespace kinestat
