// Recursive descent over the tokens of one condition; its values are left to parse_expression.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "expression/condition.hpp"
#include "expression/parse/scanner.hpp"

namespace kinestat {

/// Builds the parts of one condition. Every parse_ function answers the index of its part, or -1
/// after the first error.
///
///   either     = both {"or" both}
///   both       = negated {"and" negated}
///   negated    = {"not"} ("(" either ")" | question | comparison)
///   question   = ("assembles" | "clears") "(" name ")"
///   comparison = value ("==" | "!=" | "<" | "<=" | ">" | ">=") value
///
/// A parenthesis belongs to a value unless a comparison or a connective stands in it.
class ConditionParser {
 public:
  ConditionParser(std::string_view text, std::vector<Token> tokens)
      : text_(text), tokens_(std::move(tokens)) {}

  std::variant<Condition, ExpressionError> parse();

 private:
  int parse_either();
  int parse_both();
  int parse_negated();
  int parse_group();
  int parse_question();
  int parse_comparison();
  int parse_value();
  std::optional<Comparison> parse_operator();

  const Token& token() const { return tokens_[at_]; }

  std::string_view text_of(const Token& token) const;
  std::string_view text_between(std::size_t first, std::size_t end) const;
  bool is_symbol(std::size_t at, std::string_view symbols) const;
  bool is_word(std::size_t at, std::string_view word) const;
  bool ends_value(std::size_t at) const;
  bool is_operator(std::size_t at) const;
  static std::optional<Comparison> find_operator(std::string_view text);
  std::size_t end_of_operator() const;
  std::size_t end_of_value() const;
  bool opens_condition() const;
  bool asks(std::size_t at) const;
  int add(ConditionPart part, std::size_t first_token);

  int fail(std::size_t first, std::size_t end, std::string message, std::string hint = {});
  int fail_operator();
  int fail_missing();
  int fail_uncompared(std::size_t first);
  int fail_chain(std::size_t first, std::size_t middle);
  int fail_leftover();
  int fail_if_value(std::size_t first, int part);
  void hint_at_capitals(std::size_t first);

  std::string_view text_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::vector<ConditionPart> parts_;
  std::vector<ConditionValue> values_;
  std::vector<ConditionQuestion> questions_;
  std::optional<ExpressionError> error_;
};

}  // namespace kinestat
