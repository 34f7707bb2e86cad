// Recursive descent over the tokens of one expression.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "expression/expression.hpp"
#include "expression/parse/scanner.hpp"

namespace kinestat {

/// Builds the nodes of one expression. Every parse_ function answers the index of its node, or -1
/// after the first error.
///
///   sum      = product {("+" | "-") product}
///   product  = signed {("*" | "/") signed}
///   signed   = {"+" | "-"} measure
///   measure  = (number | "(" sum ")") unit ["^" exponent] | power
///   power    = atom ["^" exponent]
///   exponent = {"+" | "-"} power
///   atom     = number | unit | name | "pi" | function "(" sum {"," sum} ")" | "(" sum ")"
class Parser {
 public:
  Parser(std::string_view text, std::vector<Token> tokens)
      : text_(text), tokens_(std::move(tokens)) {}

  std::variant<Expression, ExpressionError> parse();

 private:
  int parse_sum();
  int parse_product();
  int parse_signed();
  int parse_measure();
  int parse_power();
  int parse_exponent();
  int parse_raised(int base, std::size_t first_token);
  int parse_signs(int (Parser::*parse_operand)());
  int parse_atom();
  int parse_number();
  int parse_word();
  int parse_group();
  int parse_call();
  int parse_arguments(const FunctionName& function, std::size_t first_token);
  int add_call(Function function, const std::vector<int>& values, std::size_t first_token);
  int parse_nested_sum();

  const Token& token() const { return tokens_[at_]; }

  std::string_view text_of(const Token& token) const;
  bool is_symbol(const Token& token, std::string_view symbols) const;
  bool is_call(std::size_t at) const;
  bool accept(std::string_view symbol);
  bool is_decimal_comma() const;
  int add_leaf(Node node);
  int add(Node node, std::size_t first_token);
  int name_index(std::string_view name);

  int fail(const Token& where, std::string message, std::string hint = {});
  int fail_too_deep();
  int fail_missing_value();
  int fail_function();
  int fail_unit(const Token& number, const Token& word);
  int fail_condition(const Token& where, std::string_view word, std::string_view what);
  int fail_unknown_function();
  int fail_unclosed(const Token& opening);
  int fail_argument_count(const FunctionName& function, const Token& name, std::size_t count);
  int fail_leftover();
  int fail_comma();
  int fail_symbol(const Token& where);
  std::string product_hint() const;
  std::string factor() const;
  std::size_t closing_of(std::size_t opening) const;

  std::string_view text_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  int depth_ = 0;
  bool has_decimal_comma_ = false;
  std::vector<Node> nodes_;
  std::vector<std::string> names_;
  std::optional<ExpressionError> error_;
};

}  // namespace kinestat
