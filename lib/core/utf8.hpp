// Characters of UTF-8 text: read, written, counted, measured; which may stand in a text, and how
// bytes are shown that are none.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace kinestat {

/// The mark that some editors put before UTF-8 text; it is not part of the text.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

struct Character {
  char32_t code = 0;     ///< the code point, or the byte where there is none
  std::size_t size = 0;  ///< [bytes]; 0: not a character
  bool is_truncated = false;
};

/// What begins at that byte: overlong forms and surrogates are no characters.
Character character_at(std::string_view text, std::size_t at);

/// Whether the byte is a control character of ASCII, such as a line feed.
inline bool is_ascii_control(char byte) {
  const auto code = static_cast<unsigned char>(byte);
  return code < 0x20 || code == 0x7F;
}

/// Whether the byte is not inside a character.
inline bool begins_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
}

/// The bytes of a code point.
std::string utf8_of(char32_t code);

/// Code points of a text that is UTF-8.
std::size_t count_characters(std::string_view text);

/// The columns that a character takes in a terminal: 2 for a wide one, 0 for one that is drawn into
/// the one before it.
std::size_t columns_of(char32_t code);

/// The columns of a text that is UTF-8.
std::size_t columns_of(std::string_view text);

/// Whether it leaves no trace on the screen: spaces, marks of format, and what Unicode says to pass
/// by where it is not known. Marks that change the character before them are seen in it.
bool is_invisible(char32_t code);

enum class CharacterFault {
  invalid,    ///< bytes that begin no UTF-8 character, overlong forms and surrogates included
  truncated,  ///< the text ends inside a character
  control,    ///< C0 but tab and line feed, DEL, C1 but next-line; also a lone carriage return
  forbidden   ///< U+FFFE, U+FFFF, and a byte order mark inside the text
};

/// The first character that may not stand in a text.
struct BadCharacter {
  CharacterFault fault = CharacterFault::invalid;
  std::size_t offset = 0;  ///< of its first byte
  char32_t code = 0;       ///< the code point, or the byte where there is none
};

/// Looks for the first character that YAML forbids; a carriage return may stand before a line feed.
std::optional<BadCharacter> find_bad_character(std::string_view text);

/// The bytes as they can be shown in a message: what is no printable character stands as \xNN.
std::string printable(std::string_view bytes);

/// The first character outside printable ASCII, for messages in which it looks like another:
/// "'а' (U+0430)", or "U+202E" alone for one that cannot be seen. Empty if there is none.
std::string foreign_character(std::string_view text);

}  // namespace kinestat
