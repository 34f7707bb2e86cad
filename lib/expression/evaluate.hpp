// The value of an expression in SI, with its dimension.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "expression/expression.hpp"
#include "expression/expression_error.hpp"
#include "expression/file_units.hpp"
#include "expression/quantity.hpp"

namespace kinestat {

/// The value of a name, or null for a name that is not known.
using NameLookup = std::function<const Quantity*(std::string_view)>;

/// The lookup of a place where no parameter may stand.
const Quantity* no_names(std::string_view name);

/// The value of an expression; always finite. `known` are the names that a hint may suggest.
/// Errors: E0309 for dimensions that do not fit, E0311 for an unknown name, E0316 where there is no
/// finite value (division by zero, sqrt(-1), log(0)); each at the smallest part that shows it.
std::variant<Quantity, ExpressionError> evaluate(const Expression& expression,
                                                 const NameLookup& lookup,
                                                 std::span<const std::string> known = {});

/// The number in SI that a value means at its place. A bare number counts in the file's unit of
/// that kind; anything else must fit (see fits). A lead is in metres per turn, also when it was
/// written per radian. Errors: E0309, naming both in words, and E0316 when the unit makes the
/// number too large. They carry no offset.
std::variant<double, ExpressionError> fit(const Quantity& value,
                                          QuantityKind kind,
                                          const FileUnits& units);

/// evaluate, then fit; an error of fit covers the whole text.
std::variant<double, ExpressionError> evaluate_as(QuantityKind kind,
                                                  const Expression& expression,
                                                  const FileUnits& units,
                                                  const NameLookup& lookup,
                                                  std::span<const std::string> known = {});

}  // namespace kinestat
