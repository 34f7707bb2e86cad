// Expressions and conditions whose names are resolved once, to be evaluated often.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "expression/condition.hpp"
#include "expression/expression.hpp"
#include "expression/quantity.hpp"

namespace kinestat {

/// The place of a name in a list of values, or -1.
using SlotOf = std::function<int(const std::string&)>;

/// The values of names, of which some have none.
struct Slots {
  std::vector<Quantity> values;
  std::vector<bool> has_value;
};

/// An expression with the places of its names. It gives the same bits as evaluate<double>.
class SlotExpression {
 public:
  /// Every name must have a place.
  SlotExpression(Expression expression, const SlotOf& slot_of);

  const Expression& expression() const { return expression_; }

  /// The places that it reads, of each name of the expression.
  std::span<const int> slots() const { return slots_; }

  /// Empty where evaluate has an error or a name has no value. `scratch` is kept by the caller, so
  /// that evaluating allocates nothing.
  std::optional<Quantity> evaluate(const Slots& slots, std::vector<Quantity>& scratch) const;

 private:
  Expression expression_;
  std::vector<int> slots_;  ///< of each name of the expression
};

/// What answers a question of a condition.
struct SlotAnswer {
  std::vector<int> slots;  ///< the places that it reads
  /// Empty where there is no answer.
  std::function<std::optional<bool>(const Slots&, std::vector<Quantity>& scratch)> holds;
};

using AnswerOf = std::function<SlotAnswer(const ConditionQuestion&)>;

/// A condition with the places of its names.
class SlotCondition {
 public:
  /// Every name must have a place, and every question an answer.
  SlotCondition(Condition condition, const SlotOf& slot_of, const AnswerOf& answer_of = {});

  /// The places that it reads.
  std::span<const int> slots() const { return slots_; }

  /// Whether it holds, as evaluate_condition<double> finds it; empty where that has an error.
  std::optional<bool> holds(const Slots& slots, std::vector<Quantity>& scratch) const;

 private:
  std::optional<bool> part_holds(int index,
                                 const Slots& slots,
                                 std::vector<Quantity>& scratch) const;

  Condition condition_;
  std::vector<SlotExpression> values_;
  std::vector<SlotAnswer> answers_;
  std::vector<int> slots_;
};

}  // namespace kinestat
