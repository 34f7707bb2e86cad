// Arithmetic on quantities, with what is wrong when there is no result.
#pragma once

#include <string>
#include <string_view>
#include <variant>

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

/// A quantity that is finite, or the fault: E0309 for dimensions, E0316 for values.
using Outcome = std::variant<Quantity, Fault>;

Outcome add(const Quantity& a, const Quantity& b);
Outcome subtract(const Quantity& a, const Quantity& b);
Outcome multiply(const Quantity& a, const Quantity& b);
Outcome divide(const Quantity& a, const Quantity& b);
Outcome raise(const Quantity& base, const Quantity& exponent);

/// A function of two values uses both, one of a single value ignores `b`.
Outcome apply(Function function, const Quantity& a, const Quantity& b);

/// The result if it is finite and its dimension is one that a computer can count.
Outcome checked(const Quantity& result);

}  // namespace kinestat
