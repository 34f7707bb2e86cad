#include "io/byte_scan.hpp"

#include <fmt/format.h>

#include "core/utf8.hpp"
#include "io/internal/source_map.hpp"

namespace kinestat {

namespace {

using namespace std::string_view_literals;

// Text of four bytes a character begins with a mark, or its ASCII characters leave three zero.
bool looks_like_utf32(std::string_view text) {
  if (text.starts_with("\xFF\xFE\0\0"sv) || text.starts_with("\0\0\xFE\xFF"sv)) {
    return true;
  }
  return text.size() >= 4 && (text.substr(0, 3) == "\0\0\0"sv || text.substr(1, 3) == "\0\0\0"sv);
}

// UTF-16 text begins with a mark, or its ASCII characters leave every second byte zero.
bool looks_like_utf16(std::string_view text) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    return true;
  }
  if (text.size() < 4) {
    return false;
  }
  const bool is_even = text[0] == '\0' && text[1] != '\0' && text[2] == '\0';
  const bool is_odd = text[0] != '\0' && text[1] == '\0' && text[3] == '\0';
  return is_even || is_odd;
}

std::string message(const BadCharacter& bad, std::size_t offset) {
  const auto number = static_cast<unsigned>(bad.code);
  switch (bad.fault) {
    case CharacterFault::invalid:
      return fmt::format("byte 0x{:02X} at offset {} is not UTF-8", number, offset);
    case CharacterFault::truncated:
      return fmt::format("the file ends inside the character that begins at offset {}", offset);
    case CharacterFault::control:
      return bad.code == '\r'
                 ? fmt::format("carriage return without line feed at offset {}", offset)
                 : fmt::format("control character U+{:04X} at offset {}", number, offset);
    case CharacterFault::forbidden:
      return fmt::format("character U+{:04X} at offset {} is not allowed in YAML", number, offset);
  }
  return {};
}

std::string_view hint(const BadCharacter& bad) {
  if (bad.fault == CharacterFault::invalid || bad.fault == CharacterFault::truncated) {
    return "save the file as UTF-8";
  }
  return bad.code == '\r' ? "save the file with line ends LF or CRLF" : "remove the character";
}

SourceRange place(std::string_view text, std::size_t offset) {
  SourceRange where = {.line = 1, .column = 1, .length = 1};
  for (std::size_t i = 0; i < offset; ++i) {
    if (text[i] == '\n') {
      ++where.line;
      where.column = 1;
    } else if (begins_character(text[i])) {
      ++where.column;
    }
  }
  return where;
}

}  // namespace

bool scan_bytes(const SourceFile& source, Diagnostics& found) {
  const bool is_utf32 = looks_like_utf32(source.text);
  if (is_utf32 || looks_like_utf16(source.text)) {
    found.error(
        "E0202", {}, fmt::format("the file is UTF-{}", is_utf32 ? 32 : 16), "save it as UTF-8");
    return false;
  }
  const std::string_view whole = source.text;
  const std::size_t skipped = whole.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
  const std::string_view text = whole.substr(skipped);
  const std::optional<BadCharacter> bad = find_bad_character(text);
  if (!bad) {
    return true;
  }
  const bool is_encoding =
      bad->fault == CharacterFault::invalid || bad->fault == CharacterFault::truncated;
  found.error(is_encoding ? "E0202" : "E0203",
              place(text, bad->offset),
              message(*bad, bad->offset + skipped),
              std::string(hint(*bad)));
  return false;
}

}  // namespace kinestat
