#include "io/internal/scalar_place.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string_view>

#include "core/utf8.hpp"
#include "io/internal/scalar_end.hpp"

namespace kinestat {

namespace {

std::size_t common_length(std::string_view a, std::string_view b) {
  return static_cast<std::size_t>(std::ranges::mismatch(a, b).in1 - a.begin());
}

// Quotes included; the text stands one-to-one where nothing else is between them.
void place_quoted(YamlNode& node, SourceMap& map, std::size_t begin) {
  const std::size_t end = find_quote_end(map.text(), begin);
  node.where = map.range(begin, end);
  const std::string_view inside = std::string_view(map.text().all()).substr(begin + 1);
  const bool is_whole = end == begin + node.text.size() + 2 && inside.starts_with(node.text) &&
                        node.where.length == 2 + static_cast<int>(count_characters(node.text));
  if (is_whole && end <= map.line_end(begin)) {
    node.text_column = node.where.column + 1;
  }
}

// The first line of a folded text is what source and text have in common.
void place_plain(YamlNode& node, SourceMap& map, std::size_t begin) {
  const std::string_view source = std::string_view(map.text().all()).substr(begin);
  const std::size_t shown = common_length(source, node.text);
  const std::size_t last = source.substr(0, shown).find_last_not_of(" \t\r\n");
  node.where = map.range(begin, begin + (last == std::string_view::npos ? 0 : last + 1));
  if (shown == node.text.size() && begin + shown <= map.line_end(begin)) {
    node.text_column = node.where.column;
  }
}

// How many digits belong to an escape of this letter.
std::size_t hexadecimal_digits(char letter) {
  switch (letter) {
    case 'x':
      return 2;
    case 'u':
      return 4;
    case 'U':
      return 8;
    default:
      return 0;
  }
}

// Whether the digits are the number of a character that YAML forbids; see find_bad_character.
bool is_bad_code(std::string_view digits) {
  constexpr int kHexadecimal = 16;
  std::uint32_t code = ' ';
  std::from_chars(digits.data(), digits.data() + digits.size(), code, kHexadecimal);
  const bool is_control = code < 0x20 && code != '\t' && code != '\n';
  const bool is_late_control = code >= 0x7F && code <= 0x9F && code != 0x85;
  return is_control || is_late_control || code == 0xFEFF || code == 0xFFFE || code == 0xFFFF;
}

}  // namespace

YamlNode make_scalar(SourceMap& map, std::size_t begin, const std::string& value) {
  YamlNode node;
  node.kind = YamlKind::scalar;
  node.text = value;
  const char first = map.text()[begin];
  node.quoted = is_one_of(first, "'\"|>");
  if (!node.quoted) {
    place_plain(node, map, begin);
  } else if (first == '|' || first == '>') {
    node.where = map.range(begin, map.text().skip_word(begin));
  } else {
    place_quoted(node, map, begin);
  }
  return node;
}

Escape find_bad_escape(const YamlText& text, std::size_t begin) {
  const std::size_t end = find_quote_end(text, begin);
  for (std::size_t at = begin; at < end && text[begin] == '"'; ++at) {
    if (text[at] != '\\') {
      continue;
    }
    const std::size_t size = 2 + hexadecimal_digits(text[at + 1]);
    if (is_one_of(text[at + 1], "0abefrvN_") || is_bad_code(text.part(at + 2, at + size))) {
      return {.begin = at, .size = size};
    }
    ++at;
  }
  return {.begin = begin, .size = 1};
}

bool is_null_word(const YamlText& text, std::size_t at) {
  const std::string_view word = text.part(at, text.skip_word(at));
  return word == "~" || word == "null" || word == "Null" || word == "NULL";
}

}  // namespace kinestat
