// Units of measurement: their names, their size in SI and expressions of them such as N*mm.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "expression/expression_error.hpp"
#include "expression/quantity.hpp"

namespace kinestat {

/// The size of a unit in SI as numerator * π^pi_power / denominator, with whole numbers, so that
/// 6 mm is exactly the double next to 0.006 and that it can be bound to exact numbers.
struct UnitScale {
  double numerator = 1.0;
  double denominator = 1.0;
  int pi_power = 0;

  friend bool operator==(const UnitScale&, const UnitScale&) = default;

  /// A value counted in this unit, in SI.
  double to_si(double value) const;

  /// A value in SI, counted in this unit.
  double from_si(double value) const;

  /// A value in SI as it is written in this unit: the number of at most fifteen figures that reads
  /// back as this very value, where there is one, so that what was typed comes back as typed; else
  /// as from_si.
  double written_from_si(double value) const;

  /// SI per unit: 0.001 for mm.
  double factor() const { return to_si(1.0); }
};

UnitScale operator*(const UnitScale& a, const UnitScale& b);
UnitScale operator/(const UnitScale& a, const UnitScale& b);

/// A unit that has a name of its own.
struct Unit {
  std::string_view name;
  UnitScale scale;
  Dimension dimension;
};

/// The unit of that name, or null. Upper and lower case differ.
const Unit* find_unit(std::string_view name);

/// Every unit's name, for messages: m, mm, um, …
std::span<const std::string> unit_names();

/// A unit put together from others, as written: "N*mm".
struct UnitExpression {
  UnitScale scale;
  Dimension dimension;
  std::string text;
};

/// Reads names of units joined by '*', '/' and '^' with whole exponents, such as N*mm, rad/s, rpm,
/// m/s^2 or 1/s. Errors: E0308 with the offset.
std::variant<UnitExpression, ExpressionError> parse_unit(std::string_view text);

}  // namespace kinestat
