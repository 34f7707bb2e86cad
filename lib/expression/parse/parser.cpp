#include "expression/parse/parser.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "expression/parse/limits.hpp"

namespace kinestat {

namespace {

NodeKind operation_of(char symbol) {
  switch (symbol) {
    case '+':
      return NodeKind::add;
    case '-':
      return NodeKind::subtract;
    case '*':
      return NodeKind::multiply;
    default:
      return NodeKind::divide;
  }
}

bool takes(Arity arity, std::size_t count) {
  switch (arity) {
    case Arity::one:
      return count == 1;
    case Arity::two:
      return count == 2;
    case Arity::two_or_more:
      break;
  }
  return count >= 2;
}

}  // namespace

std::variant<Expression, ExpressionError> Parser::parse() {
  const int root = parse_sum();
  if (root >= 0 && token().kind != TokenKind::end) {
    fail_leftover();
  }
  if (error_) {
    return *error_;
  }
  return Expression(std::string(text_), std::move(nodes_), std::move(names_));
}

int Parser::parse_sum() {
  const std::size_t first = at_;
  int left = parse_product();
  while (left >= 0 && is_symbol(token(), "+-")) {
    const NodeKind kind = operation_of(text_of(token())[0]);
    ++at_;
    const int right = parse_product();
    left = right < 0 ? -1 : add({.kind = kind, .left = left, .right = right}, first);
  }
  return left;
}

int Parser::parse_product() {
  const std::size_t first = at_;
  int left = parse_signed();
  while (left >= 0 && is_symbol(token(), "*/")) {
    const NodeKind kind = operation_of(text_of(token())[0]);
    ++at_;
    const int right = parse_signed();
    left = right < 0 ? -1 : add({.kind = kind, .left = left, .right = right}, first);
  }
  return left;
}

int Parser::parse_signed() {
  return parse_signs(&Parser::parse_measure);
}

int Parser::parse_exponent() {
  return parse_signs(&Parser::parse_power);
}

int Parser::parse_signs(int (Parser::*parse_operand)()) {
  const std::size_t first = at_;
  bool is_negative = false;
  for (; is_symbol(token(), "+-"); ++at_) {
    is_negative = is_negative != is_symbol(token(), "-");
  }
  const int operand = (this->*parse_operand)();
  return operand >= 0 && is_negative ? add({.kind = NodeKind::negate, .left = operand}, first)
                                     : operand;
}

int Parser::parse_measure() {
  const std::size_t first = at_;
  const bool is_number = token().kind == TokenKind::number;
  if (!is_number && !is_symbol(token(), "(")) {
    return parse_power();
  }
  const int value = is_number ? parse_number() : parse_group();
  if (value < 0 || token().kind != TokenKind::name || is_call(at_)) {
    return value < 0 ? -1 : parse_raised(value, first);
  }
  const Unit* unit = find_unit(text_of(token()));
  if (unit == nullptr) {
    return is_number ? fail_unit(tokens_[first], token()) : fail_leftover();
  }
  const int power = parse_raised(add_leaf({.kind = NodeKind::unit, .unit = unit}), at_ - 1);
  return power < 0 ? -1 : add({.kind = NodeKind::multiply, .left = value, .right = power}, first);
}

int Parser::parse_power() {
  const std::size_t first = at_;
  const int base = parse_atom();
  return base < 0 ? -1 : parse_raised(base, first);
}

int Parser::parse_raised(int base, std::size_t first_token) {
  if (!accept("^")) {
    return base;
  }
  if (++depth_ > kDeepestNesting) {
    return fail_too_deep();
  }
  const int exponent = parse_exponent();
  --depth_;
  return exponent < 0
             ? -1
             : add({.kind = NodeKind::power, .left = base, .right = exponent}, first_token);
}

int Parser::parse_atom() {
  if (token().kind == TokenKind::number) {
    return parse_number();
  }
  if (is_call(at_)) {
    return parse_call();
  }
  if (token().kind == TokenKind::name) {
    return parse_word();
  }
  return is_symbol(token(), "(") ? parse_group() : fail_missing_value();
}

int Parser::parse_number() {
  return add_leaf({.kind = NodeKind::number, .value = token().value});
}

int Parser::parse_word() {
  const std::string_view word = text_of(token());
  if (const Unit* unit = find_unit(word)) {
    return add_leaf({.kind = NodeKind::unit, .unit = unit});
  }
  if (word == "pi") {
    return add_leaf({.kind = NodeKind::pi});
  }
  if (find_function(word) != nullptr) {
    return fail_function();
  }
  if (is_condition_word(word)) {
    return fail_condition(token(), word, "joins conditions");
  }
  return add_leaf({.kind = NodeKind::name, .name = name_index(word)});
}

int Parser::parse_group() {
  const Token opening = token();
  ++at_;
  const int inside = parse_nested_sum();
  if (inside < 0 || accept(")")) {
    return inside;
  }
  return fail_unclosed(opening);
}

int Parser::parse_call() {
  const std::size_t first = at_;
  const FunctionName* function = find_function(text_of(token()));
  if (function == nullptr) {
    return fail_unknown_function();
  }
  at_ += 2;
  return parse_arguments(*function, first);
}

int Parser::parse_arguments(const FunctionName& function, std::size_t first_token) {
  std::vector<int> values;
  do {
    has_decimal_comma_ = has_decimal_comma_ || is_decimal_comma();
    at_ += values.empty() ? 0 : 1;
    values.push_back(parse_nested_sum());
    if (values.back() < 0) {
      return -1;
    }
  } while (is_symbol(token(), ","));
  if (!accept(")")) {
    return fail_unclosed(tokens_[first_token + 1]);
  }
  if (!takes(function.arity, values.size())) {
    return fail_argument_count(function, tokens_[first_token], values.size());
  }
  return add_call(function.function, values, first_token);
}

int Parser::add_call(Function function, const std::vector<int>& values, std::size_t first_token) {
  Node call{.kind = NodeKind::function, .function = function, .left = values[0]};
  if (values.size() == 1) {
    return add(call, first_token);
  }
  for (std::size_t i = 1; i < values.size(); ++i) {
    call.right = values[i];
    call.left = add(call, first_token);
  }
  return call.left;
}

int Parser::parse_nested_sum() {
  if (++depth_ > kDeepestNesting) {
    return fail_too_deep();
  }
  const int result = parse_sum();
  --depth_;
  return result;
}

std::string_view Parser::text_of(const Token& token) const {
  return text_.substr(static_cast<std::size_t>(token.offset),
                      static_cast<std::size_t>(token.length));
}

bool Parser::is_symbol(const Token& token, std::string_view symbols) const {
  return token.kind == TokenKind::symbol &&
         symbols.find(text_of(token)[0]) != std::string_view::npos;
}

// A unit's name before a parenthesis is a unit whose operator was forgotten, unless it is min.
bool Parser::is_call(std::size_t at) const {
  if (tokens_[at].kind != TokenKind::name || !is_symbol(tokens_[at + 1], "(")) {
    return false;
  }
  const std::string_view word = text_of(tokens_[at]);
  return find_function(word) != nullptr || !is_reserved_name(word);
}

bool Parser::accept(std::string_view symbol) {
  const bool is_there = is_symbol(token(), symbol);
  at_ += is_there ? 1 : 0;
  return is_there;
}

int Parser::add_leaf(Node node) {
  const std::size_t first = at_;
  ++at_;
  return add(node, first);
}

// The node's text reaches from the first token to the one just read.
int Parser::add(Node node, std::size_t first_token) {
  const Token& last = tokens_[at_ - 1];
  node.offset = tokens_[first_token].offset;
  node.length = last.offset + last.length - node.offset;
  nodes_.push_back(node);
  return static_cast<int>(nodes_.size()) - 1;
}

int Parser::name_index(std::string_view name) {
  const auto at = std::ranges::find(names_, name);
  const auto index = at - names_.begin();
  if (at == names_.end()) {
    names_.emplace_back(name);
  }
  return static_cast<int>(index);
}

}  // namespace kinestat
