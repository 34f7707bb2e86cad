// What the parser says about a text that is no expression.
#include <array>

#include <fmt/format.h>

#include "expression/internal/parser.hpp"
#include "expression/internal/suggestion.hpp"

namespace kinestat {

namespace {

constexpr std::string_view kKnownSymbols = "+-*/^(),";

struct SymbolHint {
  char symbol = ' ';
  std::string_view hint;
};

constexpr auto kSymbolHints = std::to_array<SymbolHint>({
    {'=', "write the value alone: its name is the key before the colon"},
    {'.', "write * for a product and digits on both sides of a decimal point"},
    {'%', "write 0.05 for 5 percent, mod(a, b) for a remainder"},
    {'[', "write ( ) around what belongs together"},
    {']', "write ( ) around what belongs together"},
    {'{', "write ( ) around what belongs together"},
    {'}', "write ( ) around what belongs together"},
    {'\'', "write names without quotes"},
    {'"', "write names without quotes"},
});

}  // namespace

int Parser::fail(const Token& where, std::string message, std::string hint) {
  error_ = {.offset = where.offset,
            .length = where.length,
            .code = "E0308",
            .message = std::move(message),
            .hint = std::move(hint)};
  return -1;
}

int Parser::fail_too_deep() {
  fail(token(), "the expression is nested too deeply", "divide it among parameters");
  error_->code = "E0210";
  return -1;
}

int Parser::fail_missing_value() {
  if (token().kind == TokenKind::end && at_ == 0) {
    error_ = {.code = "E0308",
              .message = "the value is empty",
              .hint = "write a number or an expression such as 20 deg"};
    return -1;
  }
  if (token().kind == TokenKind::end) {
    const Token& before = tokens_[at_ - 1];
    return fail(before, fmt::format("a value is missing after '{}'", text_of(before)));
  }
  if (!is_symbol(token(), kKnownSymbols)) {
    return fail_symbol(token());
  }
  const bool is_double_star =
      at_ > 0 && is_symbol(token(), "*") && is_symbol(tokens_[at_ - 1], "*");
  return fail(token(),
              fmt::format("a value is missing before '{}'", text_of(token())),
              is_double_star ? "write ^ for a power" : "");
}

int Parser::fail_unit(const Token& number, const Token& word) {
  const std::string_view name = text_of(word);
  if (is_reserved_name(name)) {
    return fail(word,
                fmt::format("an operator is missing before '{}'", name),
                fmt::format("write {}*{}", text_of(number), name));
  }
  const std::string hint = unit_hint(name);
  const bool is_near = hint.starts_with("did");
  return fail(
      word,
      fmt::format("unknown unit '{}'", name),
      is_near ? hint : fmt::format("{}; for a product write {}*{}", hint, text_of(number), name));
}

int Parser::fail_unknown_function() {
  const std::string_view name = text_of(token());
  fail(token(), fmt::format("unknown function '{}'", name), function_hint(name));
  error_->code = "E0311";
  return -1;
}

int Parser::fail_unclosed(const Token& opening) {
  return token().kind == TokenKind::end
             ? fail(opening, "'(' is not closed", "write the missing ')'")
             : fail_leftover();
}

int Parser::fail_argument_count(const FunctionName& function,
                                const Token& name,
                                std::size_t count) {
  const std::string_view wanted = function.arity == Arity::one   ? "one value"
                                  : function.arity == Arity::two ? "two values"
                                                                 : "two values or more";
  return fail(name,
              fmt::format("'{}' takes {}, not {}", function.name, wanted, count),
              has_decimal_comma_ ? "write a decimal point: 1.5, not 1,5" : "");
}

// A token where an operator or the end should be.
int Parser::fail_leftover() {
  if (is_symbol(token(), ",")) {
    return fail_comma();
  }
  if (is_symbol(token(), ")")) {
    return fail(token(), "')' closes nothing", "remove it, or write the missing '('");
  }
  if (token().kind == TokenKind::symbol && !is_symbol(token(), "(")) {
    return fail_symbol(token());
  }
  const std::string_view text = text_of(token());
  return fail(token(),
              fmt::format("an operator is missing before '{}'", text),
              fmt::format("write * before '{}' for a product", text));
}

bool Parser::is_decimal_comma() const {
  if (at_ == 0 || !is_symbol(token(), ",")) {
    return false;
  }
  const Token& before = tokens_[at_ - 1];
  const Token& after = tokens_[at_ + 1];
  return before.kind == TokenKind::number && after.kind == TokenKind::number &&
         before.offset + before.length == token().offset && token().offset + 1 == after.offset;
}

int Parser::fail_comma() {
  if (!is_decimal_comma()) {
    return fail(token(), "',' separates the values of a function only");
  }
  const Token& before = tokens_[at_ - 1];
  const Token& after = tokens_[at_ + 1];
  Token whole = before;
  whole.length = after.offset + after.length - before.offset;
  return fail(whole,
              fmt::format("'{}' has a decimal comma", text_of(whole)),
              fmt::format("write {}.{}", text_of(before), text_of(after)));
}

int Parser::fail_symbol(const Token& where) {
  const char symbol = text_of(where)[0];
  std::string_view hint = "operators are + - * / ^ and parentheses";
  for (const SymbolHint& row : kSymbolHints) {
    hint = row.symbol == symbol ? row.hint : hint;
  }
  return fail(where, fmt::format("'{}' cannot stand in an expression", symbol), std::string(hint));
}

}  // namespace kinestat
