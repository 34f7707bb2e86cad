#include "expression/expression.hpp"

#include <utility>

#include "expression/parse/decimal_to_double.hpp"
#include "expression/parse/limits.hpp"
#include "expression/parse/parser.hpp"
#include "expression/parse/scanner.hpp"

namespace kinestat {

namespace {

Expression plain_number(std::string_view text, double value) {
  std::vector<Node> nodes = {Node{.length = static_cast<int>(text.size()), .value = value}};
  return {std::string(text), std::move(nodes), {}};
}

}  // namespace

Expression::Expression(std::string text, std::vector<Node> nodes, std::vector<std::string> names)
    : text_(std::move(text)), nodes_(std::move(nodes)), names_(std::move(names)) {}

std::string_view Expression::text_of(const Node& node) const {
  return std::string_view(text_).substr(static_cast<std::size_t>(node.offset),
                                        static_cast<std::size_t>(node.length));
}

std::variant<Expression, ExpressionError> parse_expression(std::string_view text) {
  if (auto error = find_too_long(text, "expression")) {
    return std::move(*error);
  }
  if (const auto value = read_plain_number(text)) {
    return plain_number(text, *value);
  }
  auto tokens = scan(text);
  if (auto* error = std::get_if<ExpressionError>(&tokens)) {
    return std::move(*error);
  }
  return Parser(text, std::get<std::vector<Token>>(std::move(tokens))).parse();
}

}  // namespace kinestat
