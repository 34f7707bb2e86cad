// A condition as typed, such as N3 == N1 + 2*N2: its text and its tree.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "expression/evaluate.hpp"
#include "expression/expression.hpp"
#include "expression/expression_error.hpp"

namespace kinestat {

enum class Comparison { equal, unequal, less, at_most, greater, at_least };

/// What a part of a condition does: compares two values, asks a question, negates a part, or joins
/// two by `and` (both) or by `or` (either).
enum class ConditionKind { comparison, question, negation, both, either };

/// One part of a condition. Operands of a comparison are indices of Condition::values(), that of a
/// question is one of Condition::questions(), those of the others are indices of parts that stand
/// before it; -1 where there is none.
struct ConditionPart {
  ConditionKind kind = ConditionKind::comparison;
  Comparison comparison = Comparison::equal;  ///< of a comparison
  int left = -1;
  int right = -1;
  int offset = 0;  ///< [bytes] where its text begins
  int length = 0;  ///< [bytes]
};

/// One side of a comparison.
struct ConditionValue {
  Expression expression;
  int offset = 0;  ///< [bytes] where it begins in the text of the condition
};

/// What is asked of something that is no number: assembles(planet).
struct ConditionQuestion {
  std::string word;
  std::string of;
  int offset = 0;  ///< [bytes] where its text begins
  int length = 0;  ///< [bytes]
};

/// Parts in one vector, the root last. A default one has no parts and always holds.
class Condition {
 public:
  Condition() = default;
  Condition(std::string text,
            std::vector<ConditionPart> parts,
            std::vector<ConditionValue> values,
            std::vector<ConditionQuestion> questions = {});

  /// As typed.
  const std::string& text() const { return text_; }

  std::span<const ConditionPart> parts() const { return parts_; }

  std::span<const ConditionValue> values() const { return values_; }

  std::span<const ConditionQuestion> questions() const { return questions_; }

  /// The names that values refer to, each once, in the order of first use.
  std::span<const std::string> names() const { return names_; }

 private:
  std::string text_;
  std::vector<ConditionPart> parts_;
  std::vector<ConditionValue> values_;
  std::vector<ConditionQuestion> questions_;
  std::vector<std::string> names_;
};

/// Reads comparisons of expressions by == != < <= > >= and questions, joined by `not`, `and`, `or`
/// (in the order of their binding) and parentheses. Comparisons are not chained. Errors: E0308 for
/// the form, those of parse_expression in its values, E0210 above 4096 bytes or 64 levels of
/// nesting.
std::variant<Condition, ExpressionError> parse_condition(std::string_view text);

/// Whether a condition holds. `and` and `or` stop as soon as the answer is known, so that
/// b != 0 and a/b > 2 has one for b = 0. Values are compared exactly if `Number` is Exact and both
/// have exact values (and their difference does not hang on the digits of pi); otherwise those
/// within kSameValue of each other are equal, hence neither < nor >. Questions, which numbers do
/// not answer, are taken to hold. `Number` is double or Exact. Errors: those of evaluate, and E0309
/// for values of different dimensions.
template <class Number = double>
std::variant<bool, ExpressionError> evaluate_condition(
    const Condition& condition,
    const std::type_identity_t<BasicNameLookup<Number>>& lookup,
    std::span<const std::string> known = {});

}  // namespace kinestat
