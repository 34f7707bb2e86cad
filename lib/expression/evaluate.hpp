// The value of an expression in SI, with its dimension.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

#include "expression/expression.hpp"
#include "expression/expression_error.hpp"
#include "expression/file_units.hpp"
#include "expression/quantity.hpp"

namespace kinestat {

/// The value of a name, or null for a name that is not known.
template <class Number>
using BasicNameLookup = std::function<const BasicQuantity<Number>*(std::string_view)>;

using NameLookup = BasicNameLookup<double>;

/// The lookup of a place where no parameter may stand, for any type of number.
inline std::nullptr_t no_names(std::string_view /*name*/) {
  return nullptr;
}

/// The value of an expression; always finite. `known` are the names that a hint may suggest.
/// Errors: E0309 for dimensions that do not fit, E0311 for an unknown name, E0316 where there is no
/// finite value (division by zero, sqrt(-1), log(0), tan(90 deg)) or a product or power is too
/// small to differ from zero; each at the smallest part that shows it. They do not depend on the
/// type of number, which is double, Dual, Exact or ExactInput.
template <class Number = double>
std::variant<BasicQuantity<Number>, ExpressionError> evaluate(
    const Expression& expression,
    const std::type_identity_t<BasicNameLookup<Number>>& lookup,
    std::span<const std::string> known = {});

/// The number in SI that a value means at its place. A bare number counts in the file's unit of
/// that kind; anything else must fit (see fits). A lead is in metres per turn, also when it was
/// written per radian. Errors: E0309, naming both in words, and E0316 when the unit makes the
/// number too large or too small. They carry no offset.
template <class Number = double>
std::variant<Number, ExpressionError> fit(const std::type_identity_t<BasicQuantity<Number>>& value,
                                          QuantityKind kind,
                                          const FileUnits& units);

/// evaluate, then fit; an error of fit covers the whole text.
template <class Number = double>
std::variant<Number, ExpressionError> evaluate_as(
    QuantityKind kind,
    const Expression& expression,
    const FileUnits& units,
    const std::type_identity_t<BasicNameLookup<Number>>& lookup,
    std::span<const std::string> known = {});

}  // namespace kinestat
