// Single characters of an expression: classes of ASCII and advice on those outside it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "expression/expression_error.hpp"

namespace kinestat {

inline bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

inline bool is_name_start(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

inline bool is_name_part(char c) {
  return is_name_start(c) || is_digit(c);
}

/// The unit that is no letter: U+00B0.
inline constexpr std::string_view kDegreeSign = "\u00B0";

inline bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

/// Whether one of the characters stands at that place.
inline bool has(std::string_view text, std::size_t at, std::string_view characters) {
  return at < text.size() && characters.find(text[at]) != std::string_view::npos;
}

inline bool has_digit(std::string_view text, std::size_t at) {
  return at < text.size() && is_digit(text[at]);
}

inline bool has_name_start(std::string_view text, std::size_t at) {
  return at < text.size() && is_name_start(text[at]);
}

/// The first place from `at` on that is no digit.
inline std::size_t skip_digits(std::string_view text, std::size_t at) {
  while (has_digit(text, at)) {
    ++at;
  }
  return at;
}

/// The text with every `unwanted` left out.
std::string without(std::string_view text, char unwanted);

/// The first character that is neither printable ASCII, white space nor the degree sign, named by
/// its code point (E0308), with what to type instead where it is a common look-alike.
std::optional<ExpressionError> find_foreign_character(std::string_view text);

}  // namespace kinestat
