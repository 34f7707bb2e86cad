// What of a sum as typed is mere rounding, as 100.1 - 100 - 0.1 of doubles.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "core/index.hpp"
#include "core/rounding.hpp"
#include "core/tolerance.hpp"
#include "expression/expression.hpp"
#include "math/numbers/zero_within_bound.hpp"

namespace kinestat {

/// Doubles, for error_of. `value_at` answers the value of the node of an index.
template <class ValueAt>
struct DoublesOfNodes {
  using Number = double;

  double value(int index) const { return value_at(index); }

  static double constant(double value) { return value; }

  static double magnitude(double a) { return std::abs(a); }

  static double sum(double a, double b) { return a + b; }

  static double product(double a, double b) { return a * b; }

  static double quotient(double a, double b) { return a / b; }

  static std::optional<double> known_error(int /*index*/) { return std::nullopt; }

  static void keep_error(int /*index*/, double /*error*/) {}

  ValueAt value_at;
};

template <class Numbers>
auto error_of(std::span<const Node> nodes, const Numbers& numbers, int index) ->
    typename Numbers::Number;

/// Whole numbers are what is typed up to here.
inline constexpr double kLargestWhole = 0x1p53;

template <class Numbers>
auto find_error_of(std::span<const Node> nodes, const Numbers& numbers, int index) ->
    typename Numbers::Number {
  const Node& node = nodes[at(index)];
  const auto error = [&](int operand) { return error_of(nodes, numbers, operand); };
  const auto size = [&](int operand) { return numbers.magnitude(numbers.value(operand)); };
  const auto share = [&](double of) { return numbers.product(size(index), numbers.constant(of)); };
  const auto rounding = [&] { return share(kEpsilon / 2.0); };
  switch (node.kind) {
    case NodeKind::number:
      return node.value == std::floor(node.value) && node.value <= kLargestWhole
                 ? numbers.constant(0.0)
                 : rounding();
    case NodeKind::unit:
    case NodeKind::pi:
      return rounding();
    case NodeKind::negate:
      return error(node.left);
    case NodeKind::add:
    case NodeKind::subtract:
      return numbers.sum(numbers.sum(error(node.left), error(node.right)), rounding());
    case NodeKind::multiply:
      return numbers.sum(numbers.sum(numbers.product(error(node.left), size(node.right)),
                                     numbers.product(size(node.left), error(node.right))),
                         rounding());
    case NodeKind::divide:
      return numbers.sum(
          numbers.quotient(
              numbers.sum(error(node.left), numbers.product(size(index), error(node.right))),
              size(node.right)),
          rounding());
    case NodeKind::name:
    case NodeKind::power:
    case NodeKind::function:
      break;
  }
  return share(kDataRounding);
}

/// How far the value of a node may be from what is typed: decimals are rounded once, whole numbers
/// below 2^53 not at all, names and functions like data; every operation rounds its result.
/// `numbers` does the arithmetic, as DoublesOfNodes, and may keep what it found.
template <class Numbers>
auto error_of(std::span<const Node> nodes, const Numbers& numbers, int index) ->
    typename Numbers::Number {
  if (const auto& known = numbers.known_error(index)) {
    return *known;
  }
  const typename Numbers::Number found = find_error_of(nodes, numbers, index);
  numbers.keep_error(index, found);
  return found;
}

/// How far the terms of a sum are off, together.
template <class Numbers>
auto error_of_terms(std::span<const Node> nodes, const Numbers& numbers, const Node& sum) ->
    typename Numbers::Number {
  return numbers.sum(error_of(nodes, numbers, sum.left), error_of(nodes, numbers, sum.right));
}

constexpr bool is_sum(NodeKind kind) {
  return kind == NodeKind::add || kind == NodeKind::subtract;
}

/// Below this a rounding of a whole number, as 0.1*30, is none.
inline constexpr double kSurelyWhole = 0x1p40;

/// The value of a sum, or zero where it is mere rounding of its terms, of which it is then less
/// than half the larger.
template <class ValueAt>
double settled_sum(std::span<const Node> nodes, ValueAt value_at, const Node& sum, double value) {
  const double larger = std::max(std::abs(value_at(sum.left)), std::abs(value_at(sum.right)));
  // Terms that are whole are no fractions by rounding, as counts of teeth.
  const bool is_whole = value == std::floor(value) && larger == std::floor(larger);
  if (value == 0.0 || std::abs(value) > larger / 2.0 || (is_whole && larger < kSurelyWhole)) {
    return value;
  }
  const DoublesOfNodes<ValueAt> numbers{value_at};
  return zero_within_bound(value, error_of_terms(nodes, numbers, sum));
}

}  // namespace kinestat
