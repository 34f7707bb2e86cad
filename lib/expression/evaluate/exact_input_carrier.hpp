// Evaluation of numbers as typed.
#pragma once

#include <string_view>

#include "expression/evaluate/carrier.hpp"
#include "expression/expression.hpp"
#include "expression/units.hpp"
#include "math/numbers/exact_input.hpp"

namespace kinestat {

template <>
struct Carrier<ExactInput> {
  static ExactInput number(std::string_view literal, double value);
  static ExactInput pi();
  static ExactInput to_si(const ExactInput& count, const UnitScale& unit);
  static ExactInput from_si(const ExactInput& value, const UnitScale& unit);
  static ExactInput apply(const Node& operation, const ExactInput& a, const ExactInput& b);
};

}  // namespace kinestat
