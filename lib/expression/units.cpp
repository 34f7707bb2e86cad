#include "expression/units.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "expression/decimal_figures.hpp"
#include "expression/expression.hpp"
#include "expression/parse/characters.hpp"
#include "expression/parse/suggestion.hpp"

namespace kinestat {

namespace {

constexpr Dimension kLength{1, 0, 0, 0};
constexpr Dimension kMass{0, 1, 0, 0};
constexpr Dimension kTime{0, 0, 1, 0};
constexpr Dimension kAngle{0, 0, 0, 1};
constexpr Dimension kAngularVelocity{0, 0, -1, 1};
constexpr Dimension kForce{1, 1, -2, 0};
constexpr Dimension kMoment{2, 1, -2, 0};
constexpr Dimension kPower{2, 1, -3, 0};
constexpr Dimension kPressure{-1, 1, -2, 0};

// The foot, the pound and standard gravity are exact by definition (yard and pound agreement of
// 1959: 0.3048 m, 0.45359237 kg; CGPM 1901: 9.80665 m/s^2), and what is made of them too; but the
// numerator of a horsepower of 550 ft*lbf/s, 37284993579113511, is no double: one more is.
constexpr auto kUnits = std::to_array<Unit>({
    {"m", {}, kLength},
    {"mm", {1, 1000}, kLength},
    {"um", {1, 1'000'000}, kLength},
    {"cm", {1, 100}, kLength},
    {"km", {1000}, kLength},
    {"in", {254, 10'000}, kLength},  // exactly 25.4 mm
    {"ft", {3048, 10'000}, kLength},
    {"rad", {}, kAngle},
    {"deg", {1, 180, 1}, kAngle},
    {kDegreeSign, {1, 180, 1}, kAngle},
    {"rev", {2, 1, 1}, kAngle},
    {"s", {}, kTime},
    {"ms", {1, 1000}, kTime},
    {"min", {60}, kTime},
    {"h", {3600}, kTime},
    {"kg", {}, kMass},
    {"g", {1, 1000}, kMass},
    {"lb", {45'359'237, 100'000'000}, kMass},
    {"N", {}, kForce},
    {"kN", {1000}, kForce},
    {"kgf", {980'665, 100'000}, kForce},
    {"lbf", {44'482'216'152'605, 10'000'000'000'000}, kForce},
    {"Nm", {}, kMoment},
    {"J", {}, kMoment},
    {"kJ", {1000}, kMoment},
    {"MJ", {1'000'000}, kMoment},
    {"Wh", {3600}, kMoment},
    {"kWh", {3'600'000}, kMoment},
    {"rpm", {1, 30, 1}, kAngularVelocity},  // 2π/60 rad/s
    {"Hz", {2, 1, 1}, kAngularVelocity},    // one turn a second
    {"W", {}, kPower},
    {"kW", {1000}, kPower},
    {"hp", {37'284'993'579'113'512, 50'000'000'000'000}, kPower},
    {"Pa", {}, kPressure},
    {"MPa", {1'000'000}, kPressure},
    {"psi", {44'482'216'152'605, 6'451'600'000}, kPressure},
});

std::vector<std::string> list_unit_names() {
  std::vector<std::string> names;
  for (const Unit& unit : kUnits) {
    names.emplace_back(unit.name);
  }
  return names;
}

// Walks the nodes of an expression that may hold nothing but units.
class UnitReader {
 public:
  explicit UnitReader(const Expression& expression) : expression_(expression) {}

  std::variant<UnitExpression, ExpressionError> read();

 private:
  std::optional<UnitExpression> convert(const Node& node);
  std::optional<UnitExpression> convert_number(const Node& node);
  std::optional<UnitExpression> convert_power(const Node& node);
  std::optional<UnitExpression> fail(const Node& node, std::string message, std::string hint = {});

  const UnitExpression& part(int index) const { return parts_[static_cast<std::size_t>(index)]; }

  const Expression& expression_;
  std::vector<UnitExpression> parts_;  // one a node, in the order of the nodes
  ExpressionError error_;
};

std::variant<UnitExpression, ExpressionError> UnitReader::read() {
  for (const Node& node : expression_.nodes()) {
    std::optional<UnitExpression> part = convert(node);
    if (!part) {
      return error_;
    }
    parts_.push_back(std::move(*part));
  }
  UnitExpression whole = parts_.back();
  if (is_bare(whole.dimension)) {
    fail(expression_.nodes().back(), "this is a number, not a unit", "write a unit such as mm");
    return error_;
  }
  whole.text = expression_.text();
  return whole;
}

std::optional<UnitExpression> UnitReader::convert(const Node& node) {
  switch (node.kind) {
    case NodeKind::number:
      return convert_number(node);
    case NodeKind::unit:
      return UnitExpression{node.unit->scale, node.unit->dimension, {}};
    case NodeKind::multiply:
      return UnitExpression{part(node.left).scale * part(node.right).scale,
                            part(node.left).dimension * part(node.right).dimension,
                            {}};
    case NodeKind::divide:
      return UnitExpression{part(node.left).scale / part(node.right).scale,
                            part(node.left).dimension / part(node.right).dimension,
                            {}};
    case NodeKind::power:
      return convert_power(node);
    case NodeKind::name: {
      const std::string_view name = expression_.text_of(node);
      return fail(node, fmt::format("unknown unit '{}'", name), unit_hint(name));
    }
    case NodeKind::pi:
    case NodeKind::negate:
    case NodeKind::add:
    case NodeKind::subtract:
    case NodeKind::function:
      break;
  }
  return fail(
      node, "a unit is made of unit names, '*', '/' and '^' only", "write for example N*mm");
}

// A number is the 1 of 1/s or an exponent, which the power then takes from the node itself.
std::optional<UnitExpression> UnitReader::convert_number(const Node& node) {
  const auto nodes = expression_.nodes();
  const int index = static_cast<int>(&node - nodes.data());
  const bool may_stand = std::ranges::any_of(nodes, [&](const Node& other) {
    return (other.kind == NodeKind::power && other.right == index) ||
           (other.kind == NodeKind::divide && other.left == index && node.value == 1.0);
  });
  if (may_stand || nodes.size() == 1) {
    return UnitExpression{};
  }
  return fail(node, "a unit carries no number", "write the unit alone, such as mm");
}

std::optional<UnitExpression> UnitReader::convert_power(const Node& node) {
  constexpr double kLargestUnitExponent = 9.0;
  const Node& exponent = expression_.nodes()[static_cast<std::size_t>(node.right)];
  const bool is_whole = exponent.kind == NodeKind::number &&
                        exponent.value == std::floor(exponent.value) && exponent.value >= 1.0 &&
                        exponent.value <= kLargestUnitExponent;
  if (!is_whole) {
    return fail(exponent, "the exponent of a unit is a whole number from 1 to 9", "write s^2");
  }
  UnitExpression result;
  for (int i = 0; i < static_cast<int>(exponent.value); ++i) {
    result.scale = result.scale * part(node.left).scale;
    result.dimension = result.dimension * part(node.left).dimension;
  }
  return result;
}

std::optional<UnitExpression> UnitReader::fail(const Node& node,
                                               std::string message,
                                               std::string hint) {
  error_ = {.offset = node.offset,
            .length = node.length,
            .code = "E0308",
            .message = std::move(message),
            .hint = std::move(hint)};
  return std::nullopt;
}

// numerator * π^pi_power
double above(const UnitScale& scale) {
  return scale.pi_power == 0 ? scale.numerator
                             : scale.numerator * std::pow(std::numbers::pi, scale.pi_power);
}

}  // namespace

double UnitScale::to_si(double value) const {
  return value * above(*this) / denominator;
}

double UnitScale::from_si(double value) const {
  return value * denominator / above(*this);
}

double UnitScale::written_from_si(double value) const {
  if (*this == UnitScale{}) {
    return value;
  }
  const double nearest = from_si(value);
  const double typed = round_to_figures(nearest, std::numeric_limits<double>::digits10);
  return to_si(typed) == value ? typed : nearest;
}

UnitScale operator*(const UnitScale& a, const UnitScale& b) {
  return {a.numerator * b.numerator, a.denominator * b.denominator, a.pi_power + b.pi_power};
}

UnitScale operator/(const UnitScale& a, const UnitScale& b) {
  return {a.numerator * b.denominator, a.denominator * b.numerator, a.pi_power - b.pi_power};
}

// Every name in an expression might be a unit: first letters tell most apart.
const Unit* find_unit(std::string_view name) {
  const auto at = std::ranges::find_if(kUnits, [name](const Unit& unit) {
    return name.starts_with(unit.name.front()) && unit.name == name;
  });
  return at != kUnits.end() ? &*at : nullptr;
}

std::span<const std::string> unit_names() {
  static const std::vector<std::string> names = list_unit_names();
  return names;
}

std::variant<UnitExpression, ExpressionError> parse_unit(std::string_view text) {
  auto parsed = parse_expression(text);
  if (const auto* error = std::get_if<ExpressionError>(&parsed)) {
    return *error;
  }
  return UnitReader(std::get<Expression>(parsed)).read();
}

}  // namespace kinestat
