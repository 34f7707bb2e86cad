#include "expression/parse/scanner.hpp"

#include <charconv>
#include <cmath>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "expression/parse/characters.hpp"
#include "expression/parse/number_format_errors.hpp"

namespace kinestat {

namespace {

std::size_t skip_exponent(std::string_view text, std::size_t at) {
  const std::size_t sign = has(text, at + 1, "+-") ? 1 : 0;
  const bool is_exponent = has(text, at, "eE") && has_digit(text, at + 1 + sign);
  return is_exponent ? skip_digits(text, at + 1 + sign) : at;
}

// Where the decimal that begins at `at` ends: digits, point, digits, exponent.
std::size_t end_of_decimal(std::string_view text, std::size_t at) {
  at = skip_digits(text, at);
  if (has(text, at, ".")) {
    const std::size_t after = skip_exponent(text, skip_digits(text, at + 1));
    const bool is_name_next = after == at + 1 && after < text.size() && is_name_start(text[after]);
    return is_name_next ? at : after;
  }
  return skip_exponent(text, at);
}

bool has_nonzero_digit(std::string_view literal) {
  const std::string_view mantissa = literal.substr(0, literal.find_first_of("eE"));
  return mantissa.find_first_of("123456789") != std::string_view::npos;
}

// Where the first digit that is not zero stands, as a power of ten, decides between too large and
// too small, because from_chars reports both alike.
bool is_below_one(std::string_view literal) {
  const std::size_t mark = literal.find_first_of("eE");
  if (mark != std::string_view::npos) {
    return literal[mark + 1] == '-';
  }
  return literal.find('.') < literal.find_first_of("123456789");
}

// Empty if no double holds the number: then `out_of_range` is 0 or infinity.
std::optional<double> to_double(std::string_view literal, double& out_of_range) {
  double value = 0.0;
  const auto [end, fault] = std::from_chars(literal.data(), literal.data() + literal.size(), value);
  if (fault == std::errc::result_out_of_range || std::isinf(value) ||
      (value == 0.0 && has_nonzero_digit(literal))) {
    out_of_range = is_below_one(literal) ? 0.0 : HUGE_VAL;
    return std::nullopt;
  }
  return value;
}

std::variant<Token, ExpressionError> scan_number(std::string_view text, std::size_t begin) {
  const std::size_t end = end_of_decimal(text, begin);
  if (auto error = find_foreign_number(text, begin, end)) {
    return std::move(*error);
  }
  const std::string_view literal = text.substr(begin, end - begin);
  double out_of_range = 0.0;
  const std::optional<double> value = to_double(literal, out_of_range);
  if (!value) {
    return number_out_of_range(text, begin, end, out_of_range == 0.0);
  }
  return Token{.kind = TokenKind::number,
               .offset = static_cast<int>(begin),
               .length = static_cast<int>(end - begin),
               .value = *value};
}

// YAML's .nan and .inf.
std::optional<ExpressionError> find_special_value(std::string_view text, std::size_t begin) {
  const std::string word = in_small_letters(text.substr(begin, 4));
  if (word != ".nan" && word != ".inf") {
    return std::nullopt;
  }
  return not_finite(text, begin, begin + word.size());
}

Token scan_name(std::string_view text, std::size_t begin) {
  std::size_t end = begin;
  while (end < text.size() && is_name_part(text[end])) {
    ++end;
  }
  return {.kind = TokenKind::name,
          .offset = static_cast<int>(begin),
          .length = static_cast<int>(end - begin)};
}

std::variant<Token, ExpressionError> scan_token(std::string_view text, std::size_t at) {
  if (is_digit(text[at]) || (text[at] == '.' && has_digit(text, at + 1))) {
    return scan_number(text, at);
  }
  if (is_name_start(text[at])) {
    return scan_name(text, at);
  }
  if (auto error = find_special_value(text, at)) {
    return std::move(*error);
  }
  return Token{.kind = TokenKind::symbol, .offset = static_cast<int>(at), .length = 1};
}

// A number in digits right after another one.
std::optional<ExpressionError> find_second_number(std::string_view text,
                                                  const std::vector<Token>& before,
                                                  std::size_t at) {
  const bool follows_number = !before.empty() && before.back().kind == TokenKind::number;
  return follows_number && is_digit(text[at]) ? find_spaced_number(text, before.back().offset, at)
                                              : std::nullopt;
}

}  // namespace

std::variant<std::vector<Token>, ExpressionError> scan(std::string_view text) {
  if (auto error = find_foreign_character(text)) {
    return std::move(*error);
  }
  std::vector<Token> tokens;
  std::size_t at = 0;
  while (at < text.size()) {
    if (is_space(text[at])) {
      ++at;
      continue;
    }
    if (auto error = find_second_number(text, tokens, at)) {
      return std::move(*error);
    }
    auto scanned = scan_token(text, at);
    if (auto* error = std::get_if<ExpressionError>(&scanned)) {
      return std::move(*error);
    }
    tokens.push_back(std::get<Token>(scanned));
    at += static_cast<std::size_t>(tokens.back().length);
  }
  tokens.push_back({.kind = TokenKind::end, .offset = static_cast<int>(text.size())});
  return tokens;
}

std::optional<double> read_plain_number(std::string_view text) {
  const std::size_t sign = has(text, 0, "+-") ? 1 : 0;
  const bool begins = has_digit(text, sign) || (has(text, sign, ".") && has_digit(text, sign + 1));
  const bool is_octal = has(text, sign, "0") && has_digit(text, sign + 1);
  if (!begins || is_octal || end_of_decimal(text, sign) != text.size()) {
    return std::nullopt;
  }
  double out_of_range = 0.0;
  const std::optional<double> value = to_double(text.substr(sign), out_of_range);
  return value && text[0] == '-' ? std::optional(0.0 - *value) : value;
}

}  // namespace kinestat
