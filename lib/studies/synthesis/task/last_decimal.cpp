#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "studies/synthesis/task/task_positions.hpp"

namespace kinestat {

namespace {

// The place value of the last digit behind the point of a literal; empty for a whole number.
std::optional<double> last_place(std::string_view literal) {
  const std::size_t end = std::min(literal.find_first_of("eE"), literal.size());
  const std::size_t point = literal.find('.');
  if (point >= end || point + 1 == end) {
    return std::nullopt;
  }
  int exponent = 0;
  if (end < literal.size()) {
    const std::size_t sign = literal[end + 1] == '+' ? 1 : 0;
    std::from_chars(literal.data() + end + 1 + sign, literal.data() + literal.size(), exponent);
  }
  return std::pow(10.0, exponent - static_cast<double>(end - point - 1));
}

// The only number of an expression that is nothing but a number, its sign and its unit.
const Node* find_literal(const Expression& expression) {
  const Node* literal = nullptr;
  for (const Node& node : expression.nodes()) {
    const bool is_number = node.kind == NodeKind::number;
    const bool is_part = node.kind == NodeKind::unit || node.kind == NodeKind::negate ||
                         node.kind == NodeKind::multiply;
    if (!is_part && !(is_number && literal == nullptr)) {
      return nullptr;
    }
    literal = is_number ? &node : literal;
  }
  return literal;
}

class LastDecimalFinder {
 public:
  explicit LastDecimalFinder(const MechanismDescription& description)
      : task_(*description.synthesis), positions_(description) {}

  LastDecimal run() {
    LastDecimal result;
    for (const PositionDescription& position : task_.positions) {
      take_point(position.at, result);
      for (const PoseDerivative& derivative : position.derivatives) {
        take_point(derivative.at, result);
      }
      for (const Value& angle : position.angles) {
        take(angle, QuantityKind::angle, result.angle);
      }
    }
    return result;
  }

  // Half a unit of the last decimal, if it has one.
  std::optional<double> half_unit(const Value& value, QuantityKind kind) const {
    const Node* literal = find_literal(value.expression);
    if (literal == nullptr || literal->value == 0.0) {
      return std::nullopt;
    }
    const auto place = last_place(value.expression.text_of(*literal));
    if (!place) {
      return std::nullopt;
    }
    Diagnostics none;
    const double unit = std::abs(positions_.number(value, kind, none) / literal->value);
    return 0.5 * unit * *place;
  }

 private:
  void take_point(const PointDescription& point, LastDecimal& result) const {
    for (const Value& value : point.coordinates) {
      take(value, QuantityKind::length, result.length);
    }
  }

  void take(const Value& value, QuantityKind kind, double& half) const {
    if (const auto found = half_unit(value, kind)) {
      half = half > 0.0 ? std::min(half, *found) : *found;
    }
  }

  const SynthesisDescription& task_;
  TaskPositions<double> positions_;
};

}  // namespace

LastDecimal last_decimal_of(const MechanismDescription& description) {
  return LastDecimalFinder(description).run();
}

double rounding_of(const PointDescription& point, const MechanismDescription& description) {
  const LastDecimalFinder finder(description);
  double square = 0.0;
  for (const Value& value : point.coordinates) {
    const double half = finder.half_unit(value, QuantityKind::length).value_or(0.0);
    square += half * half;
  }
  return std::sqrt(square);
}

}  // namespace kinestat
