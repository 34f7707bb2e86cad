#include "expression/parse/scanner.hpp"

#include <string>

#include <fmt/format.h>

#include "core/spelling.hpp"
#include "expression/parse/characters.hpp"
#include "expression/parse/decimal_to_double.hpp"
#include "expression/parse/number_format_errors.hpp"
#include "expression/units.hpp"

namespace kinestat {

namespace {

std::variant<Token, ExpressionError> scan_number(std::string_view text, std::size_t begin) {
  const std::size_t end = end_of_decimal(text, begin);
  if (auto error = find_foreign_number(text, begin, end)) {
    return std::move(*error);
  }
  const std::string_view literal = text.substr(begin, end - begin);
  double out_of_range = 0.0;
  const std::optional<double> value = double_of(literal, out_of_range);
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

// Whether a name goes on there behind a dot: traced points have a number in theirs, coupler.1.at.x.
bool goes_on(std::string_view text, std::size_t at) {
  const std::size_t end = skip_digits(text, at);
  return has_name_start(text, end == at ? at : end + 1) && (end == at || text[end] == '.');
}

// Names of quantities of reports have a dot, a.wz; between two units it stands for a product.
Token scan_name(std::string_view text, std::size_t begin) {
  const auto end_of_part = [&](std::size_t at) {
    while (at < text.size() && is_name_part(text[at])) {
      ++at;
    }
    return at;
  };
  std::size_t end = end_of_part(begin);
  std::size_t part = begin;
  while (end < text.size() && text[end] == '.' && goes_on(text, end + 1)) {
    const std::size_t next = end_of_part(end + 1);
    if (find_unit(text.substr(part, end - part)) != nullptr &&
        find_unit(text.substr(end + 1, next - end - 1)) != nullptr) {
      break;
    }
    part = end + 1;
    end = next;
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
  if (text.substr(at).starts_with(kDegreeSign)) {
    return Token{.kind = TokenKind::name,
                 .offset = static_cast<int>(at),
                 .length = static_cast<int>(kDegreeSign.size())};
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

}  // namespace kinestat
