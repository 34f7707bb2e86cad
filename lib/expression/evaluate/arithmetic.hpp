// Arithmetic on quantities, with what is wrong when there is no result.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "expression/expression.hpp"
#include "expression/functions.hpp"
#include "expression/quantity.hpp"

namespace kinestat {

/// Why an operation has no result, and which part of it to show.
struct Fault {
  enum class Part { whole, left, right };

  std::string_view code;
  std::string message;
  std::string hint;
  Part part = Part::whole;
};

/// The fault of joining different dimensions by addition or by such a word as "compared".
Fault different(const Dimension& a, const Dimension& b, std::string_view joined);

/// A quantity that is finite, or the fault: E0309 for dimensions, E0316 for values.
using Outcome = std::variant<Quantity, Fault>;

Outcome add(const Quantity& a, const Quantity& b);
Outcome subtract(const Quantity& a, const Quantity& b);
Outcome multiply(const Quantity& a, const Quantity& b);
Outcome divide(const Quantity& a, const Quantity& b);
Outcome raise(const Quantity& base, const Quantity& exponent);

/// The value of a number, a unit or pi.
Quantity leaf(const Node& node);

/// The operation of a node on its operands; `right` is `left` where there is one. `unit` is the
/// right operand if that is a unit alone: multiplying and dividing by it rounds once where possible
/// (6 mm is the double nearest to 0.006).
Outcome operate(const Node& node, const Quantity& left, const Quantity& right, const Unit* unit);

/// A function of two values uses both, one of a single value ignores `b`.
Outcome apply(Function function, const Quantity& a, const Quantity& b);

/// What it means if a result is zero.
enum class Zero {
  value,     ///< the exact result may be zero
  underflow  ///< it is not: the number is too small for a double
};

/// Of a multiple, share or power of this operand.
constexpr Zero zero_from(double operand) {
  return operand == 0.0 ? Zero::value : Zero::underflow;
}

/// The result if it is finite, no underflow, and its dimension is one that a computer can count.
Outcome checked(const Quantity& result, Zero zero = Zero::value);

}  // namespace kinestat
