// What evaluation says about an expression that has no value at its place.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "expression/evaluate/arithmetic.hpp"
#include "expression/expression.hpp"

namespace kinestat {

Fault unknown_name(std::string_view name);

/// The fault at the part of the node that it names; of an unknown name with a suggestion.
ExpressionError located(const Expression& expression,
                        const Node& node,
                        Fault fault,
                        std::span<const std::string> known);

/// A dimension where another one is expected.
ExpressionError misfit(const Dimension& dimension, QuantityKind kind);

/// Where the expression of a misfit is a number with a wrong unit, the hint has that number with
/// the units of the kind's example.
void hint_at_units(const Expression& expression, QuantityKind kind, ExpressionError& error);

/// A value that a unit of the file makes infinite.
ExpressionError too_large();

/// A value above the largest of its kind in SI, kLargestNumber or kLargestMagnitude.
ExpressionError beyond_computing(double largest);

/// A value that is not zero until a unit of the file makes it so.
ExpressionError too_small();

}  // namespace kinestat
