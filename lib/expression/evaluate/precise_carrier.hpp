// Evaluation with many digits.
#pragma once

#include <string_view>

#include "expression/evaluate/carrier.hpp"
#include "expression/expression.hpp"
#include "expression/precise.hpp"
#include "expression/units.hpp"

namespace kinestat {

template <>
struct Carrier<Precise> {
  static Precise number(std::string_view literal, double value);
  static Precise pi();
  static Precise to_si(const Precise& count, const UnitScale& unit);
  static Precise from_si(const Precise& value, const UnitScale& unit);
  static Precise apply(const Node& operation, const Precise& a, const Precise& b);
};

}  // namespace kinestat
