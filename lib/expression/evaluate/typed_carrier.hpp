// Evaluation of numbers as typed.
#pragma once

#include <string_view>

#include "expression/evaluate/carrier.hpp"
#include "expression/expression.hpp"
#include "expression/units.hpp"
#include "math/numbers/typed.hpp"

namespace kinestat {

template <>
struct Carrier<Typed> {
  static Typed number(std::string_view literal, double value);
  static Typed pi();
  static Typed to_si(const Typed& count, const UnitScale& unit);
  static Typed from_si(const Typed& value, const UnitScale& unit);
  static Typed apply(const Node& operation, const Typed& a, const Typed& b);
};

}  // namespace kinestat
