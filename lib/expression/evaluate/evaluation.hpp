// One pass over the nodes of an expression, for any type of number.
#pragma once

#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "expression/evaluate.hpp"
#include "expression/evaluate/arithmetic.hpp"
#include "expression/evaluate/evaluation_errors.hpp"
#include "expression/evaluate/number_traits.hpp"
#include "expression/evaluate/sum_rounding.hpp"

namespace kinestat {

inline const Quantity& plain(const Quantity& quantity) {
  return quantity;
}

/// The part of a value that decides on errors.
template <class Number>
Quantity plain(const BasicQuantity<Number>& quantity) {
  return {quantity.value.value, quantity.dimension};
}

/// Operands stand before operations, so that one pass from the front evaluates them all.
template <class Number>
class Evaluation {
 public:
  Evaluation(const Expression& expression, const BasicNameLookup<Number>& lookup)
      : expression_(expression), lookup_(lookup) {}

  std::variant<BasicQuantity<Number>, ExpressionError> run(std::span<const std::string> known);

 private:
  Outcome outcome_of(const Node& node) const;
  BasicQuantity<Number> completed(const Node& node, const Quantity& value) const;
  Number carried(const Node& node) const;

  const Unit* unit_at(int index) const {
    return index < 0 ? nullptr : expression_.nodes()[static_cast<std::size_t>(index)].unit;
  }

  const BasicQuantity<Number>& value(int index) const {
    return values_[static_cast<std::size_t>(index)];
  }

  const BasicQuantity<Number>* find(const Node& node) const {
    return lookup_(expression_.names()[static_cast<std::size_t>(node.name)]);
  }

  const Expression& expression_;
  const BasicNameLookup<Number>& lookup_;
  std::vector<BasicQuantity<Number>> values_;  // one a node
};

template <class Number>
auto Evaluation<Number>::run(std::span<const std::string> known)
    -> std::variant<BasicQuantity<Number>, ExpressionError> {
  values_.reserve(expression_.nodes().size());
  for (const Node& node : expression_.nodes()) {
    Outcome outcome = outcome_of(node);
    if (auto* fault = std::get_if<Fault>(&outcome)) {
      return located(expression_, node, std::move(*fault), known);
    }
    values_.push_back(completed(node, std::get<Quantity>(outcome)));
  }
  return std::move(values_.back());
}

template <class Number>
Outcome Evaluation<Number>::outcome_of(const Node& node) const {
  if (node.kind == NodeKind::name) {
    const BasicQuantity<Number>* found = find(node);
    return found == nullptr ? Outcome(unknown_name(expression_.text_of(node))) : plain(*found);
  }
  if (node.left < 0) {
    return leaf(node);
  }
  const int right = node.right < 0 ? node.left : node.right;
  Outcome outcome =
      operate(node, plain(value(node.left)), plain(value(right)), unit_at(node.right));
  if (auto* sum = is_sum(node.kind) ? std::get_if<Quantity>(&outcome) : nullptr) {
    const auto value_at = [this](int index) { return plain(value(index)).value; };
    sum->value = settled_sum(expression_.nodes(), value_at, node, sum->value);
  }
  return outcome;
}

template <class Number>
BasicQuantity<Number> Evaluation<Number>::completed(const Node& node, const Quantity& value) const {
  if constexpr (std::same_as<Number, double>) {
    return value;
  } else {
    BasicQuantity<Number> result{carried(node), value.dimension};
    result.value.value = value.value;
    return result;
  }
}

// Only of types beside double.
template <class Number>
Number Evaluation<Number>::carried(const Node& node) const {
  using Carry = NumberTraits<Number>;
  switch (node.kind) {
    case NodeKind::number:
      return Carry::number(expression_.text_of(node), node.value);
    case NodeKind::unit:
      return Carry::to_si(Carry::number("1", 1.0), node.unit->scale);
    case NodeKind::name:
      return find(node)->value;
    case NodeKind::pi:
      return Carry::pi();
    default:
      break;
  }
  const Number& left = value(node.left).value;
  const Unit* unit = unit_at(node.right);
  if (unit != nullptr && node.kind == NodeKind::multiply) {
    return Carry::to_si(left, unit->scale);
  }
  if (unit != nullptr && node.kind == NodeKind::divide) {
    return Carry::from_si(left, unit->scale);
  }
  return Carry::apply(node, left, node.right < 0 ? left : value(node.right).value);
}

}  // namespace kinestat
