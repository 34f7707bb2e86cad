#include "io/internal/parser_words.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "core/utf8.hpp"

namespace kinestat {

namespace {

struct Words {
  std::string_view parser;   // how the parser's message begins
  std::string_view message;  // {} is the word at the place
  std::string_view hint;
};

constexpr std::string_view kIndentationHint =
    "begin all keys of one mapping in the same column; quote a text that holds ': ' or ' #'";

constexpr auto kWords = std::to_array<Words>({
    {"end of map flow not found", "expected ',' or '}}' before '{}'", "separate entries by ','"},
    {"end of sequence flow not found", "expected ',' or ']' before '{}'", "separate items by ','"},
    {"end of map not found", "'{}' does not fit into the mapping above it", kIndentationHint},
    {"end of sequence not found",
     "'{}' does not fit into the list above it",
     "begin all items of one list with '- ' in the same column"},
    {"illegal map value",
     "':' cannot stand here",
     "write one 'key: value' a line, keys of one mapping in the same column; quote a text that "
     "holds ': '"},
    {"illegal map key", "'?' cannot stand here", "write 'key: value'"},
    {"illegal block entry",
     "'-' cannot begin an item here",
     "begin the list on its own line, or write [a, b]"},
    {"unknown token", "'{}' cannot begin a value", "put the text in quotes"},
    {"unknown escape character",
     "unknown escape before '{}'",
     "write \\\\ for a backslash, or use single quotes"},
    {"bad character found while scanning hex",
     "an escape before '{}' lacks hexadecimal digits",
     "\\x takes 2, \\u 4 and \\U 8 of them"},
    {"invalid unicode", "an escape before '{}' is no Unicode character", "write the character"},
    {"illegal document indicator in scalar",
     "'{}' stands inside a quoted text",
     "close the quote before it"},
    {"anchor not found after &",
     "'&' needs a name behind it",
     "put a text that begins with '&' in quotes"},
    {"alias not found after *",
     "'*' needs a name behind it",
     "put a text that begins with '*' in quotes"},
    {"unexpected character in block scalar",
     "'{}' cannot stand behind '|' or '>'",
     "begin the text on the next line, indented"},
});

constexpr std::string_view kUnknownAnchor = "the referenced anchor is not defined";

// At the end of the text the last character that shows is cited.
std::size_t place_of(const YAML::Mark& mark, const std::string& text) {
  const auto at = static_cast<std::size_t>(std::max(mark.pos, 0));
  if (at < text.size()) {
    return at;
  }
  const std::size_t last = text.find_last_not_of(" \t\r\n");
  return last == std::string::npos ? 0 : last;
}

// The word at the offset, at least one character, without a ':' behind it.
std::string word_at(const YamlText& text, std::size_t at) {
  constexpr std::size_t kLongest = 40;
  std::size_t end = text.skip_word(at);
  if (end > at + 1 && text[end - 1] == ':') {
    --end;
  }
  end = std::clamp(end, at + 1, at + kLongest);
  while (!text.is_end(end) && !is_character_start(text[end])) {
    ++end;
  }
  return printable(text.part(at, end));
}

void report_unknown_alias(SourceMap& map, std::size_t at, Diagnostics& found) {
  const std::size_t end = map.text().skip_word(at);
  found.error("E0209",
              map.range(at, end),
              fmt::format("alias '{}' names no anchor before it", word_at(map.text(), at)),
              fmt::format("mark the value as '&{}' before its first use",
                          printable(map.text().part(at + 1, end))));
}

}  // namespace

void report_parser_error(const YAML::Exception& exception,
                         SourceMap& map,
                         SourceRange last_long_quote,
                         Diagnostics& found) {
  const std::size_t at = place_of(exception.mark, map.text().all());
  if (exception.msg == kUnknownAnchor) {
    report_unknown_alias(map, at, found);
    return;
  }
  const auto* const words = std::ranges::find_if(
      kWords, [&](const Words& row) { return exception.msg.starts_with(row.parser); });
  const bool is_known = words != kWords.end();
  const std::string message =
      is_known ? fmt::format(fmt::runtime(words->message), word_at(map.text(), at))
               : printable(exception.msg);
  Diagnostic& error =
      found.error("E0204", map.at(at), message, std::string(is_known ? words->hint : ""));
  if (last_long_quote.line > 0) {
    error.notes.push_back({last_long_quote, "the quoted text that begins here goes over lines"});
  }
}

}  // namespace kinestat
