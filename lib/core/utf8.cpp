#include "core/utf8.hpp"

#include <algorithm>
#include <array>
#include <utf8proc.h>

#include <fmt/format.h>

namespace kinestat {

namespace {

constexpr char32_t kDelete = 0x7F;
constexpr char32_t kNextLine = 0x85;
constexpr char32_t kLastC1 = 0x9F;
constexpr char32_t kInnerOrderMark = 0xFEFF;

unsigned char byte_at(std::string_view text, std::size_t at) {
  return static_cast<unsigned char>(text[at]);
}

// Table 3-7 of the Unicode standard, by size: the smallest code point that needs so many bytes.
constexpr std::array<char32_t, 5> kSmallest = {0, 0, 0x80, 0x800, 0x10000};

std::size_t expected_size(unsigned char first) {
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

bool is_control(std::string_view text, std::size_t at, char32_t code) {
  if (code == '\r') {
    return at + 1 == text.size() || text[at + 1] != '\n';
  }
  const bool is_c0 = code < 0x20 && code != '\t' && code != '\n';
  return is_c0 || (code >= kDelete && code <= kLastC1 && code != kNextLine);
}

}  // namespace

Character character_at(std::string_view text, std::size_t at) {
  const unsigned char first = byte_at(text, at);
  const std::size_t size = expected_size(first);
  if (size <= 1) {
    return {.code = first, .size = size};
  }
  char32_t code = first & (0xFFU >> (size + 1));
  for (std::size_t i = 1; i < size; ++i) {
    if (at + i == text.size()) {
      return {.code = first, .is_truncated = true};
    }
    const unsigned char next = byte_at(text, at + i);
    if ((next & 0xC0U) != 0x80U) {
      return {.code = first};
    }
    code = (code << 6U) | (next & 0x3FU);
  }
  const bool is_surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < kSmallest[size] || code > 0x10FFFF || is_surrogate) {
    return {.code = first};
  }
  return {.code = code, .size = size};
}

std::string utf8_of(char32_t code) {
  std::array<utf8proc_uint8_t, 4> bytes{};
  const auto size = utf8proc_encode_char(static_cast<utf8proc_int32_t>(code), bytes.data());
  return {bytes.begin(), bytes.begin() + size};
}

std::size_t count_characters(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, begins_character));
}

std::size_t columns_of(char32_t code) {
  return static_cast<std::size_t>(
      std::max(utf8proc_charwidth(static_cast<utf8proc_int32_t>(code)), 0));
}

std::size_t columns_of(std::string_view text) {
  std::size_t columns = 0;
  for (std::size_t at = 0; at < text.size();) {
    const Character next = character_at(text, at);
    columns += columns_of(next.code);
    at += std::max<std::size_t>(next.size, 1);
  }
  return columns;
}

bool is_invisible(char32_t code) {
  const auto point = static_cast<utf8proc_int32_t>(code);
  switch (utf8proc_category(point)) {
    case UTF8PROC_CATEGORY_CC:
    case UTF8PROC_CATEGORY_CF:
    case UTF8PROC_CATEGORY_ZS:
    case UTF8PROC_CATEGORY_ZL:
    case UTF8PROC_CATEGORY_ZP:
      return true;
    case UTF8PROC_CATEGORY_MN:
      return false;
    default:
      return utf8proc_get_property(point)->ignorable != 0;
  }
}

std::optional<BadCharacter> find_bad_character(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size()) {
    const Character next = character_at(text, at);
    if (next.size == 0) {
      const auto fault = next.is_truncated ? CharacterFault::truncated : CharacterFault::invalid;
      return BadCharacter{.fault = fault, .offset = at, .code = next.code};
    }
    if (is_control(text, at, next.code)) {
      return BadCharacter{.fault = CharacterFault::control, .offset = at, .code = next.code};
    }
    if (next.code == kInnerOrderMark || next.code == 0xFFFE || next.code == 0xFFFF) {
      return BadCharacter{.fault = CharacterFault::forbidden, .offset = at, .code = next.code};
    }
    at += next.size;
  }
  return {};
}

std::string printable(std::string_view bytes) {
  std::string result;
  std::size_t at = 0;
  while (at < bytes.size()) {
    const Character next = character_at(bytes, at);
    const bool is_break = next.code == '\n' || next.code == '\t' || next.code == '\r';
    const bool is_shown = next.size > 0 && !is_break && !is_control(bytes, at, next.code) &&
                          (next.code == ' ' || !is_invisible(next.code));
    const std::size_t size = std::max<std::size_t>(next.size, 1);
    for (std::size_t i = at; i < at + size; ++i) {
      result += is_shown ? std::string(1, bytes[i]) : fmt::format("\\x{:02X}", byte_at(bytes, i));
    }
    at += size;
  }
  return result;
}

std::string foreign_character(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const Character next = character_at(text, at);
    const std::size_t size = std::max<std::size_t>(next.size, 1);
    if (next.code >= kDelete || next.code < 0x20) {
      const std::string point = fmt::format("U+{:04X}", static_cast<unsigned>(next.code));
      return is_invisible(next.code) || next.size == 0
                 ? point
                 : fmt::format("'{}' ({})", text.substr(at, size), point);
    }
    at += size;
  }
  return {};
}

}  // namespace kinestat
