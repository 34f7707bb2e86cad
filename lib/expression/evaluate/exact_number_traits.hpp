// Evaluation with exact values.
#pragma once

#include <string_view>

#include "expression/evaluate/number_traits.hpp"
#include "expression/exact.hpp"
#include "expression/expression.hpp"
#include "expression/units.hpp"

namespace kinestat {

template <>
struct NumberTraits<Exact> {
  static Exact number(std::string_view literal, double value);
  static Exact pi();
  static Exact to_si(const Exact& count, const UnitScale& unit);
  static Exact from_si(const Exact& value, const UnitScale& unit);
  static Exact apply(const Node& operation, const Exact& a, const Exact& b);
};

}  // namespace kinestat
