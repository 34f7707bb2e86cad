#include "expression/condition.hpp"

#include <algorithm>
#include <utility>

#include "expression/evaluate/condition_value.hpp"
#include "expression/parse/condition_parser.hpp"
#include "expression/parse/limits.hpp"

namespace kinestat {

namespace {

void add_new(std::span<const std::string> names, std::vector<std::string>& list) {
  for (const std::string& name : names) {
    if (std::ranges::find(list, name) == list.end()) {
      list.push_back(name);
    }
  }
}

}  // namespace

Condition::Condition(std::string text,
                     std::vector<ConditionPart> parts,
                     std::vector<ConditionValue> values,
                     std::vector<ConditionQuestion> questions)
    : text_(std::move(text)),
      parts_(std::move(parts)),
      values_(std::move(values)),
      questions_(std::move(questions)) {
  for (const ConditionValue& value : values_) {
    add_new(value.expression.names(), names_);
  }
}

std::variant<Condition, ExpressionError> parse_condition(std::string_view text) {
  if (auto error = find_too_long(text, "condition")) {
    return std::move(*error);
  }
  auto tokens = scan(text);
  if (auto* error = std::get_if<ExpressionError>(&tokens)) {
    return std::move(*error);
  }
  return ConditionParser(text, std::get<std::vector<Token>>(std::move(tokens))).parse();
}

bool holds(Comparison comparison, int order) {
  switch (comparison) {
    case Comparison::equal:
      return order == 0;
    case Comparison::unequal:
      return order != 0;
    case Comparison::less:
      return order < 0;
    case Comparison::at_most:
      return order <= 0;
    case Comparison::greater:
      return order > 0;
    case Comparison::at_least:
      break;
  }
  return order >= 0;
}

template std::variant<bool, ExpressionError> evaluate_condition<double>(
    const Condition&, const NameLookup&, std::span<const std::string>);

}  // namespace kinestat
