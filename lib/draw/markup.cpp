#include "draw/markup.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/utf8.hpp"

namespace kinestat {

namespace {

constexpr char32_t kReplacement = 0xFFFD;

// What XML 1.0 forbids or discourages: controls and non-characters.
char32_t allowed(char32_t code) {
  if (code == U'\t' || code == U'\n' || code == U'\r') {
    return U' ';
  }
  const bool is_control = code < 0x20 || (code >= 0x7F && code < 0xA0);
  return is_control || (code & 0xFFFEU) == 0xFFFE ? kReplacement : code;
}

}  // namespace

std::u32string code_points(std::string_view text) {
  std::u32string result;
  for (std::size_t at = 0; at < text.size();) {
    const Character next = character_at(text, at);
    result += next.size > 0 ? next.code : kReplacement;
    at += std::max<std::size_t>(next.size, 1);
  }
  return result;
}

std::string escape_markup(std::string_view text) {
  constexpr std::string_view kSpecial = "&<>\"'";
  if (std::ranges::all_of(text, [&](char one) {
        return one >= ' ' && one < 0x7F && kSpecial.find(one) == std::string_view::npos;
      })) {
    return std::string(text);
  }
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
        result += utf8_of(allowed(code));
    }
  }
  return result;
}

std::string format_coordinate(double value) {
  // Far outside any picture, and where two decimals would no longer be exact.
  constexpr double kFarthest = 1e7;
  KINESTAT_EXPECTS(std::isfinite(value) && std::abs(value) < kFarthest);
  // Pictures are mostly numbers: this takes a fifth of the time of a general format.
  const auto hundredths = std::abs(static_cast<int>(std::nearbyint(100.0 * value)));
  std::string text = fmt::format_int(hundredths / 100).str();
  if (const int rest = hundredths % 100; rest != 0) {
    text += {'.', static_cast<char>('0' + rest / 10)};
    if (rest % 10 != 0) {
      text += static_cast<char>('0' + rest % 10);
    }
  }
  return value < 0.0 && hundredths != 0 ? "-" + text : text;
}

}  // namespace kinestat
