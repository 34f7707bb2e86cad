// What the parser says about a text that is no expression.
#include <array>

#include <fmt/format.h>

#include "expression/parse/number_format_errors.hpp"
#include "expression/parse/parser.hpp"
#include "expression/parse/suggestion.hpp"

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
    {'|', "write abs( ) for an absolute value"},
    {';', "write , between the values of a function"},
    {'[', "write ( ) around what belongs together"},
    {']', "write ( ) around what belongs together"},
    {'{', "write ( ) around what belongs together"},
    {'}', "write ( ) around what belongs together"},
    {'\'', "write names without quotes"},
    {'"', "write names without quotes"},
});

// The hint for a symbol directly after a number, which shows what it was meant for.
std::string hint_after_number(std::string_view number, char symbol) {
  switch (symbol) {
    case '%':
      return fmt::format("write {}/100 for a percentage, mod(a, b) for a remainder", number);
    case '\'':
    case '"':
      return fmt::format(
          "write the unit by its name: {0} in for inches, {0}/60 deg for minutes of arc", number);
    default:
      return {};
  }
}

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
    return fail(before,
                fmt::format("a value is missing after '{}'", text_of(before)),
                fmt::format("write a number or a name behind '{}', or remove it", text_of(before)));
  }
  if (!is_symbol(token(), kKnownSymbols)) {
    return fail_symbol(token());
  }
  const bool is_double_star =
      at_ > 0 && is_symbol(token(), "*") && is_symbol(tokens_[at_ - 1], "*");
  return fail(token(),
              fmt::format("a value is missing before '{}'", text_of(token())),
              is_double_star ? "write ^ for a power"
                             : fmt::format("write a number or a name before '{}'{}",
                                           text_of(token()),
                                           is_symbol(token(), "*/^") ? ", or remove it" : ""));
}

// A function's name without '(' behind it.
int Parser::fail_function() {
  const std::string_view name = text_of(token());
  const Token& value = tokens_[at_ + 1];
  const bool has_value = value.kind == TokenKind::number || value.kind == TokenKind::name;
  const bool has_unit =
      value.kind == TokenKind::number && find_unit(text_of(tokens_[at_ + 2])) != nullptr;
  const Token& last = tokens_[at_ + (has_unit ? 2 : 1)];
  const auto length = static_cast<std::size_t>(last.offset + last.length - value.offset);
  return fail(token(),
              fmt::format("the function '{}' has no values", name),
              has_value ? fmt::format("write its value in parentheses: {}({})",
                                      name,
                                      text_.substr(static_cast<std::size_t>(value.offset), length))
                        : fmt::format("write {}( )", name));
}

int Parser::fail_unit(const Token& number, const Token& word) {
  const std::string_view name = text_of(word);
  if (is_condition_word(name)) {
    return fail_condition(word, name, "joins conditions");
  }
  if (is_reserved_name(name)) {
    return fail(word,
                fmt::format("an operator is missing before '{}'", name),
                fmt::format("write {}*{}", text_of(number), name));
  }
  const std::string hint = unit_hint(name);
  const bool is_near = hint.starts_with("did") || hint.starts_with("1 ");
  return fail(
      word,
      fmt::format("unknown unit '{}'", name),
      is_near ? hint : fmt::format("{}; for a product write {}*{}", hint, text_of(number), name));
}

int Parser::fail_unknown_function() {
  const std::string_view name = text_of(token());
  const std::string hint = function_hint(name);
  const bool is_near = hint.starts_with("did");
  fail(token(),
       fmt::format("unknown function '{}'", name),
       is_near ? hint : fmt::format("{}; for a product write {}*( )", hint, name));
  error_->code = "E0311";
  return -1;
}

int Parser::fail_unclosed(const Token& opening) {
  return token().kind == TokenKind::end
             ? fail(opening,
                    "'(' is not closed",
                    "write the missing ')'; in [ ] and { } a value with a comma needs quotes")
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
  if (is_condition_word(text)) {
    return fail_condition(token(), text, "joins conditions");
  }
  const bool may_be_misspelled = token().kind == TokenKind::name && !is_reserved_name(text);
  const std::string near = may_be_misspelled ? unit_hint(text) : std::string();
  return fail(
      token(),
      fmt::format("an operator is missing before '{}'", text),
      near.starts_with("did") ? fmt::format("{}; {}", near, product_hint()) : product_hint());
}

// For two values side by side, of which the second is at the token.
std::string Parser::product_hint() const {
  const Token& before = tokens_[at_ - 1];
  if (before.kind == TokenKind::number && text_of(token()) == "1" &&
      is_symbol(tokens_[at_ + 1], "/")) {
    const std::string_view name = text_of(tokens_[at_ + 2]);
    const Unit* const unit = find_unit(name);
    if (unit != nullptr && unit->dimension == dimension_of(QuantityKind::time)) {
      return name == "min" ? fmt::format("write {0} rpm for a speed of turns", text_of(before))
                           : fmt::format(
                                 "write {0} rad/{1} for an angular velocity, {0} rev/{1} if "
                                 "it counts turns",
                                 text_of(before),
                                 name);
    }
  }
  return before.kind == TokenKind::symbol
             ? fmt::format("write * before '{}' for a product", text_of(token()))
             : fmt::format("write {}*{} for a product", text_of(before), factor());
}

// The value that begins at the token, with its parentheses: "3", "(a + b)", "sin(p)". What is long
// or not closed stands as "( )".
std::string Parser::factor() const {
  constexpr int kLongest = 40;
  const std::string_view word = text_of(token());
  const std::size_t opening = is_call(at_) ? at_ + 1 : at_;
  if (!is_symbol(tokens_[opening], "(")) {
    return std::string(word);
  }
  const Token& last = tokens_[closing_of(opening)];
  const int length = last.offset + last.length - token().offset;
  if (last.kind == TokenKind::end || length > kLongest) {
    return is_call(at_) ? fmt::format("{}( )", word) : "( )";
  }
  return std::string(
      text_.substr(static_cast<std::size_t>(token().offset), static_cast<std::size_t>(length)));
}

// The parenthesis that closes the one at `opening`, or the end.
std::size_t Parser::closing_of(std::size_t opening) const {
  int open = 1;
  std::size_t at = opening;
  while (open > 0 && tokens_[at].kind != TokenKind::end) {
    ++at;
    open += is_symbol(tokens_[at], "(") ? 1 : is_symbol(tokens_[at], ")") ? -1 : 0;
  }
  return at;
}

// What belongs to a condition stands where a value is expected.
int Parser::fail_condition(const Token& where, std::string_view word, std::string_view what) {
  return fail(where,
              fmt::format("'{}' {}, and this is the place of a value", word, what),
              "write a number or an expression; conditions belong under 'require' and 'keep' only");
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
    constexpr std::size_t kLongest = 40;
    const bool is_tuple = text_.starts_with('(') && text_.ends_with(')');
    const std::string_view values = is_tuple ? text_.substr(1, text_.size() - 2) : text_;
    return fail(token(),
                "',' separates the values of a function only",
                fmt::format("write several values in brackets: [{}]",
                            values.size() > kLongest ? "…, …" : values));
  }
  const Token& before = tokens_[at_ - 1];
  const Token& after = tokens_[at_ + 1];
  error_ = decimal_comma(text_, before.offset, after.offset + after.length);
  return -1;
}

int Parser::fail_symbol(const Token& where) {
  const std::size_t at = static_cast<std::size_t>(where.offset);
  const bool has_equals = text_.substr(at + 1).starts_with('=');
  const char symbol = text_[at];
  if (symbol == '<' || symbol == '>' || (has_equals && (symbol == '=' || symbol == '!'))) {
    Token comparison = where;
    comparison.length += has_equals ? 1 : 0;
    return fail_condition(comparison, text_of(comparison), "compares");
  }
  std::string hint = "operators are + - * / ^ and parentheses";
  for (const SymbolHint& row : kSymbolHints) {
    hint = row.symbol == symbol ? row.hint : hint;
  }
  const bool follows_number = at_ > 0 && tokens_[at_ - 1].kind == TokenKind::number;
  const std::string meant =
      follows_number ? hint_after_number(text_of(tokens_[at_ - 1]), symbol) : std::string();
  return fail(where,
              fmt::format("'{}' is not allowed in an expression", symbol),
              meant.empty() ? hint : meant);
}

}  // namespace kinestat
