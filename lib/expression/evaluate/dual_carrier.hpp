// Evaluation with derivatives.
#pragma once

#include <string_view>

#include "expression/evaluate/carrier.hpp"
#include "expression/expression.hpp"
#include "expression/units.hpp"
#include "math/numbers/dual.hpp"

namespace kinestat {

template <>
struct Carrier<Dual> {
  static Dual number(std::string_view literal, double value);
  static Dual pi();
  static Dual to_si(const Dual& count, const UnitScale& unit);
  static Dual from_si(const Dual& value, const UnitScale& unit);
  static Dual apply(const Node& operation, const Dual& a, const Dual& b);
};

}  // namespace kinestat
