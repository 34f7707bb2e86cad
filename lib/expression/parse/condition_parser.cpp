#include "expression/parse/condition_parser.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "expression/parse/limits.hpp"

namespace kinestat {

namespace {

constexpr std::string_view kOperatorSymbols = "=<>!&|";

struct OperatorRow {
  std::string_view text;
  Comparison comparison = Comparison::equal;
};

constexpr auto kOperators = std::to_array<OperatorRow>({
    {"==", Comparison::equal},
    {"!=", Comparison::unequal},
    {"<", Comparison::less},
    {"<=", Comparison::at_most},
    {">", Comparison::greater},
    {">=", Comparison::at_least},
});

}  // namespace

std::variant<Condition, ExpressionError> ConditionParser::parse() {
  if (tokens_.size() == 1) {
    fail(0, 0, "the condition is empty", "write a comparison such as N3 == N1 + 2*N2");
    return *error_;
  }
  const int root = parse_either();
  if (root >= 0 && token().kind != TokenKind::end) {
    fail_leftover();
  }
  if (error_) {
    return *error_;
  }
  return Condition(
      std::string(text_), std::move(parts_), std::move(values_), std::move(questions_));
}

int ConditionParser::parse_either() {
  const std::size_t first = at_;
  int left = parse_both();
  while (left >= 0 && is_word(at_, "or")) {
    ++at_;
    const int right = parse_both();
    left =
        right < 0 ? -1 : add({.kind = ConditionKind::either, .left = left, .right = right}, first);
  }
  return left;
}

int ConditionParser::parse_both() {
  const std::size_t first = at_;
  int left = parse_negated();
  while (left >= 0 && is_word(at_, "and")) {
    ++at_;
    const int right = parse_negated();
    left = right < 0 ? -1 : add({.kind = ConditionKind::both, .left = left, .right = right}, first);
  }
  return left;
}

int ConditionParser::parse_negated() {
  const std::size_t first = at_;
  bool is_negative = false;
  for (; is_word(at_, "not"); ++at_) {
    is_negative = !is_negative;
  }
  const int operand = opens_condition() ? parse_group()
                      : asks(at_)       ? parse_question()
                                        : parse_comparison();
  return operand >= 0 && is_negative
             ? add({.kind = ConditionKind::negation, .left = operand}, first)
             : operand;
}

int ConditionParser::parse_group() {
  const std::size_t first = at_;
  if (++depth_ > kDeepestNesting) {
    fail(at_, at_ + 1, "the condition is nested too deeply", "divide it among several");
    error_->code = "E0210";
    return -1;
  }
  ++at_;
  const int inside = parse_either();
  --depth_;
  if (inside < 0) {
    return -1;
  }
  if (token().kind == TokenKind::end) {
    return fail(first, first + 1, "'(' is not closed", "write the missing ')'");
  }
  if (!is_symbol(at_, ")")) {
    return fail_leftover();
  }
  ++at_;
  return fail_if_value(first, inside);
}

// assembles(planet)
int ConditionParser::parse_question() {
  const std::size_t first = at_;
  std::size_t end = at_ + 2;
  while (tokens_[end].kind != TokenKind::end && !is_symbol(end, ")")) {
    ++end;
  }
  if (tokens_[end].kind == TokenKind::end) {
    return fail(first + 1, first + 2, "'(' is not closed", "write the missing ')'");
  }
  const std::string_view word = text_of(tokens_[first]);
  if (end == at_ + 2) {
    return fail(first,
                end + 1,
                fmt::format("'{}' lacks the name of a planet", word),
                fmt::format("write {}(planet), a gear member with a 'count'", word));
  }
  at_ = end + 1;
  questions_.push_back({.word = std::string(word),
                        .of = std::string(text_between(first + 2, end)),
                        .offset = tokens_[first].offset,
                        .length = static_cast<int>(text_between(first, at_).size())});
  const int part = add(
      {.kind = ConditionKind::question, .left = static_cast<int>(questions_.size()) - 1}, first);
  return fail_if_value(first, part);
}

int ConditionParser::parse_comparison() {
  const std::size_t first = at_;
  const int left = parse_value();
  if (left < 0) {
    return -1;
  }
  if (!is_operator(at_)) {
    return fail_uncompared(first);
  }
  const std::optional<Comparison> comparison = parse_operator();
  if (!comparison) {
    return -1;
  }
  const std::size_t middle = at_;
  const int right = parse_value();
  if (right < 0) {
    return -1;
  }
  if (is_operator(at_)) {
    return find_operator(text_between(at_, end_of_operator())) ? fail_chain(first, middle)
                                                               : fail_operator();
  }
  return add(
      {.kind = ConditionKind::comparison, .comparison = *comparison, .left = left, .right = right},
      first);
}

int ConditionParser::parse_value() {
  const std::size_t first = at_;
  at_ = end_of_value();
  if (at_ == first) {
    return fail_missing();
  }
  auto parsed = parse_expression(text_between(first, at_));
  const int offset = tokens_[first].offset;
  if (auto* error = std::get_if<ExpressionError>(&parsed)) {
    error->offset += offset;
    error_ = std::move(*error);
    hint_at_capitals(first);
    return -1;
  }
  values_.push_back({std::get<Expression>(std::move(parsed)), offset});
  return static_cast<int>(values_.size()) - 1;
}

std::optional<Comparison> ConditionParser::parse_operator() {
  const std::size_t end = end_of_operator();
  const std::optional<Comparison> comparison = find_operator(text_between(at_, end));
  if (!comparison) {
    fail_operator();
    return std::nullopt;
  }
  at_ = end;
  return comparison;
}

std::optional<Comparison> ConditionParser::find_operator(std::string_view text) {
  const auto* const row = std::ranges::find(kOperators, text, &OperatorRow::text);
  return row != kOperators.end() ? std::optional(row->comparison) : std::nullopt;
}

std::string_view ConditionParser::text_of(const Token& token) const {
  return text_.substr(static_cast<std::size_t>(token.offset),
                      static_cast<std::size_t>(token.length));
}

// Of the tokens from `first` to before `end`.
std::string_view ConditionParser::text_between(std::size_t first, std::size_t end) const {
  const Token& last = tokens_[end - 1];
  const int begin = tokens_[first].offset;
  return text_.substr(static_cast<std::size_t>(begin),
                      static_cast<std::size_t>(last.offset + last.length - begin));
}

bool ConditionParser::is_symbol(std::size_t at, std::string_view symbols) const {
  return tokens_[at].kind == TokenKind::symbol &&
         symbols.find(text_of(tokens_[at])[0]) != std::string_view::npos;
}

bool ConditionParser::is_word(std::size_t at, std::string_view word) const {
  return tokens_[at].kind == TokenKind::name && text_of(tokens_[at]) == word;
}

bool ConditionParser::is_operator(std::size_t at) const {
  return is_symbol(at, kOperatorSymbols);
}

bool ConditionParser::ends_value(std::size_t at) const {
  return is_operator(at) || is_symbol(at, ")") ||
         (tokens_[at].kind == TokenKind::name && is_condition_word(text_of(tokens_[at])));
}

// Symbols that touch each other are one operator.
std::size_t ConditionParser::end_of_operator() const {
  std::size_t end = at_ + 1;
  while (is_operator(end) && tokens_[end].offset == tokens_[end - 1].offset + 1) {
    ++end;
  }
  return end;
}

// The next comparison or connective outside parentheses.
std::size_t ConditionParser::end_of_value() const {
  std::size_t end = at_;
  for (int depth = 0; tokens_[end].kind != TokenKind::end && (depth > 0 || !ends_value(end));
       ++end) {
    depth += is_symbol(end, "(") ? 1 : is_symbol(end, ")") ? -1 : 0;
  }
  return end;
}

// Whether a question begins here.
bool ConditionParser::asks(std::size_t at) const {
  return tokens_[at].kind == TokenKind::name && is_condition_question(text_of(tokens_[at])) &&
         is_symbol(at + 1, "(");
}

// Whether a parenthesis is here, and in it a comparison, a question or a connective.
bool ConditionParser::opens_condition() const {
  if (!is_symbol(at_, "(")) {
    return false;
  }
  int depth = 1;
  for (std::size_t i = at_ + 1; depth > 0 && tokens_[i].kind != TokenKind::end; ++i) {
    depth += is_symbol(i, "(") ? 1 : is_symbol(i, ")") ? -1 : 0;
    if ((!is_symbol(i, ")") && ends_value(i)) || asks(i)) {
      return true;
    }
  }
  return false;
}

int ConditionParser::add(ConditionPart part, std::size_t first_token) {
  part.offset = tokens_[first_token].offset;
  part.length = static_cast<int>(text_between(first_token, at_).size());
  parts_.push_back(part);
  return static_cast<int>(parts_.size()) - 1;
}

}  // namespace kinestat
