// Which characters may stand in a text, and how bytes are shown that are none.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace kinestat {

/// The mark that some editors put before UTF-8 text; it is not part of the text.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

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
