#include "draw/markup.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/contract.hpp"

namespace kinestat {

namespace {

constexpr char32_t kReplacement = 0xFFFD;

// The length that the first byte of a character announces; 0 for a byte that begins none.
std::size_t announced_length(unsigned char first) {
  if (first < 0x80) {
    return 1;
  }
  if (first >= 0xC2 && first < 0xE0) {
    return 2;
  }
  if (first >= 0xE0 && first < 0xF0) {
    return 3;
  }
  return first >= 0xF0 && first < 0xF5 ? 4 : 0;
}

bool is_shortest(char32_t code, std::size_t length) {
  return length < 3 || (length == 3 ? code >= 0x800 : code >= 0x10000 && code <= 0x10FFFF);
}

bool is_surrogate(char32_t code) {
  return code >= 0xD800 && code <= 0xDFFF;
}

// The character at `at`, which moves behind it.
char32_t next_character(std::string_view text, std::size_t& at) {
  const auto first = static_cast<unsigned char>(text[at]);
  const std::size_t length = announced_length(first);
  if (length == 0 || at + length > text.size()) {
    ++at;
    return kReplacement;
  }
  char32_t code = length == 1 ? first : first & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    const auto next = static_cast<unsigned char>(text[at + i]);
    if ((next & 0xC0U) != 0x80U) {
      ++at;
      return kReplacement;
    }
    code = (code << 6U) | (next & 0x3FU);
  }
  at += length;
  return is_shortest(code, length) && !is_surrogate(code) ? code : kReplacement;
}

// What XML 1.0 forbids or discourages: controls and non-characters.
char32_t allowed(char32_t code) {
  if (code == U'\t' || code == U'\n' || code == U'\r') {
    return U' ';
  }
  const bool is_control = code < 0x20 || (code >= 0x7F && code < 0xA0);
  return is_control || (code & 0xFFFEU) == 0xFFFE ? kReplacement : code;
}

void append(char32_t code, std::string& text) {
  const auto tail = [&text](char32_t bits) { text += static_cast<char>(0x80U | (bits & 0x3FU)); };
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += static_cast<char>(0xC0U | (code >> 6U));
    tail(code);
  } else if (code < 0x10000) {
    text += static_cast<char>(0xE0U | (code >> 12U));
    tail(code >> 6U);
    tail(code);
  } else {
    text += static_cast<char>(0xF0U | (code >> 18U));
    tail(code >> 12U);
    tail(code >> 6U);
    tail(code);
  }
}

}  // namespace

std::u32string code_points(std::string_view text) {
  std::u32string result;
  for (std::size_t at = 0; at < text.size();) {
    result += next_character(text, at);
  }
  return result;
}

std::string escape_markup(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (const char32_t code : code_points(text)) {
    switch (code) {
      case U'&':
        result += "&amp;";
        break;
      case U'<':
        result += "&lt;";
        break;
      case U'>':
        result += "&gt;";
        break;
      case U'"':
        result += "&quot;";
        break;
      case U'\'':
        result += "&#39;";
        break;
      default:
        append(allowed(code), result);
    }
  }
  return result;
}

std::string format_coordinate(double value) {
  // Far outside any picture, and where two decimals would no longer be exact.
  constexpr double kFarthest = 1e7;
  KINESTAT_EXPECTS(std::isfinite(value) && std::abs(value) < kFarthest);
  std::string text = fmt::format("{:.2f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') {
    text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

}  // namespace kinestat
