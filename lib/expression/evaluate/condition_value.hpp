// Whether conditions hold, for any type of number; each type has one source that includes this.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>

#include "core/tolerance.hpp"
#include "expression/condition.hpp"
#include "expression/evaluate/arithmetic.hpp"

namespace kinestat {

struct Exact;

/// -1, 0 or 1, as a is smaller than, equal to or larger than b, within kSameValue.
inline int order_of(double a, double b) {
  if (std::abs(a - b) <= kSameValue * std::max(std::abs(a), std::abs(b))) {
    return 0;
  }
  return a < b ? -1 : 1;
}

int order_of(const Exact& a, const Exact& b);

/// Whether a comparison holds for values in that order.
bool holds(Comparison comparison, int order);

template <class Number>
class ConditionCheck {
 public:
  using Answer = std::variant<bool, ExpressionError>;

  ConditionCheck(const Condition& condition,
                 const BasicNameLookup<Number>& lookup,
                 std::span<const std::string> known)
      : condition_(condition), lookup_(lookup), known_(known) {}

  Answer answer(int index) const;

 private:
  using Value = std::variant<BasicQuantity<Number>, ExpressionError>;

  Answer compare_values(const ConditionPart& part) const;
  Value value(int index) const;

  const Condition& condition_;
  const BasicNameLookup<Number>& lookup_;
  std::span<const std::string> known_;
};

template <class Number>
auto ConditionCheck<Number>::answer(int index) const -> Answer {
  const ConditionPart& part = condition_.parts()[static_cast<std::size_t>(index)];
  if (part.kind == ConditionKind::comparison) {
    return compare_values(part);
  }
  if (part.kind == ConditionKind::question) {
    return true;
  }
  Answer left = answer(part.left);
  if (std::holds_alternative<ExpressionError>(left)) {
    return left;
  }
  const bool is_true = std::get<bool>(left);
  if (part.kind == ConditionKind::negation) {
    return !is_true;
  }
  const bool is_decided = is_true == (part.kind == ConditionKind::either);
  return is_decided ? left : answer(part.right);
}

template <class Number>
auto ConditionCheck<Number>::compare_values(const ConditionPart& part) const -> Answer {
  Value left = value(part.left);
  if (auto* error = std::get_if<ExpressionError>(&left)) {
    return std::move(*error);
  }
  Value right = value(part.right);
  if (auto* error = std::get_if<ExpressionError>(&right)) {
    return std::move(*error);
  }
  const auto& a = std::get<BasicQuantity<Number>>(left);
  const auto& b = std::get<BasicQuantity<Number>>(right);
  if (a.dimension != b.dimension) {
    Fault fault = different(a.dimension, b.dimension, "compared");
    return ExpressionError{.offset = part.offset,
                           .length = part.length,
                           .code = fault.code,
                           .message = std::move(fault.message),
                           .hint = std::move(fault.hint)};
  }
  return holds(part.comparison, order_of(a.value, b.value));
}

template <class Number>
auto ConditionCheck<Number>::value(int index) const -> Value {
  const ConditionValue& value = condition_.values()[static_cast<std::size_t>(index)];
  Value result = evaluate<Number>(value.expression, lookup_, known_);
  if (auto* error = std::get_if<ExpressionError>(&result)) {
    error->offset += value.offset;
  }
  return result;
}

template <class Number>
std::variant<bool, ExpressionError> evaluate_condition(
    const Condition& condition,
    const std::type_identity_t<BasicNameLookup<Number>>& lookup,
    std::span<const std::string> known) {
  if (condition.parts().empty()) {
    return true;
  }
  const int root = static_cast<int>(condition.parts().size()) - 1;
  return ConditionCheck<Number>(condition, lookup, known).answer(root);
}

}  // namespace kinestat
