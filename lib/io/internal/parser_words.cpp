#include "io/internal/parser_words.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "core/utf8.hpp"
#include "io/internal/text_line.hpp"

namespace kinestat {

namespace {

struct Words {
  std::string_view parser;   // how the parser's message begins
  std::string_view message;  // {} is the word at the place
  std::string_view hint;
};

constexpr std::string_view kIndentationHint =
    "begin all keys of one mapping in the same column; quote a text that holds ': ' or ' #'";

constexpr std::string_view kItemHint = "begin all items of one list with '- ' in the same column";

constexpr std::string_view kIllegalValue = "illegal map value";

constexpr std::string_view kOpenMapping = "end of map flow not found";

constexpr auto kWords = std::to_array<Words>({
    {kOpenMapping, "expected ',' or '}}' before '{}'", "separate entries by ','"},
    {"end of sequence flow not found", "expected ',' or ']' before '{}'", "separate items by ','"},
    {"end of map not found", "'{}' does not fit into the mapping above it", kIndentationHint},
    {"end of sequence not found", "'{}' does not fit into the list above it", kItemHint},
    {kIllegalValue,
     "':' is not allowed here",
     "write one 'key: value' a line, keys of one mapping in the same column; quote a text that "
     "holds ': '"},
    {"illegal map key", "'?' is not allowed here", "write 'key: value'"},
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
    {"invalid unicode", "an escape before '{}' is not a Unicode character", "write the character"},
    {"illegal document indicator in scalar",
     "'{}' is inside a quoted text",
     "close the quote before it"},
    {"anchor not found after &",
     "'&' needs a name behind it",
     "put a text that begins with '&' in quotes"},
    {"alias not found after *",
     "'*' needs a name behind it",
     "put a text that begins with '*' in quotes"},
    {"unexpected character in block scalar",
     "'{}' is not allowed after '|' or '>'",
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
  while (!text.is_end(end) && !begins_character(text[end])) {
    ++end;
  }
  return std::string(text.part(at, end));
}

// Whether the line could be a key without its ':'.
bool lacks_colon(const YamlText& text, const TextLine& line) {
  const std::string_view words = text.part(line.content, line.end);
  const bool is_item = words.starts_with("- ") || words == "-";
  const bool closes = std::ranges::count(words, ']') > std::ranges::count(words, '[') ||
                      std::ranges::count(words, '}') > std::ranges::count(words, '{');
  return words.front() != '#' && !is_item && !closes && !words.ends_with(':') &&
         words.find(": ") == std::string_view::npos;
}

// A key without ':' joins the next key, in whatever column, whose ':' the parser then refuses. The
// first of the lines above the key at `colon` that have no ':'; npos where there is none.
std::size_t find_key_without_colon(const YamlText& text, std::size_t colon) {
  const TextLine key = line_at(text, colon);
  if (text.part(key.content, colon).find(": ") != std::string_view::npos) {
    return std::string::npos;
  }
  std::size_t result = std::string::npos;
  for (std::size_t start = key.start; start > 0;) {
    const TextLine above = line_at(text, start - 1);
    start = above.start;
    if (above.is_empty()) {
      continue;
    }
    if (!lacks_colon(text, above)) {
      break;
    }
    result = above.content;
  }
  return result;
}

void report_key_without_colon(SourceMap& map, std::size_t key, Diagnostics& found) {
  const std::size_t end = map.text().skip_line(key);
  const std::string_view line = map.text().part(key, end);
  found.error("E0204",
              map.range(key, end),
              "this line has no ':' behind its key",
              line.find(':') == std::string_view::npos
                  ? "write 'key: value', or indent the line if it continues the value above"
                  : "write a space after the ':' of each key");
}

// What to type where a value on the line of the second ':' holds keys or is a text: "drive:
// coupling: a}", "name: Four-bar: big". Empty where the value is long, or begins elsewhere.
std::string hint_on_second_colon(const YamlText& text, std::size_t colon) {
  constexpr std::size_t kLongest = 60;
  const TextLine line = line_at(text, colon);
  const std::size_t begin = find_value(text, line.content);
  if (begin >= colon || line.end - begin > kLongest) {
    return {};
  }
  std::string_view value = text.part(begin, line.end);
  if (value.find('{') == std::string_view::npos && value.ends_with('}')) {
    return fmt::format(
        "write {}: {{{}", text.part(line.content, skip_key(text, line.content)), value);
  }
  return value.find_first_of("#\"{}") != std::string_view::npos
             ? std::string()
             : fmt::format(
                   "put a text in quotes: \"{0}\"; write keys of one line in braces: {{{0}}}",
                   value);
}

// Of an entry in braces that lacks its ':' or the space behind it ("at [0, 40]", "at:[0, 40]"), or
// the ',' before it ("type: revolute bodies: [a, b]"); empty if it is another.
std::string hint_on_entry(const YamlText& text, std::size_t at) {
  const std::size_t before = text.all().find_last_of(",{[]}\n", at == 0 ? 0 : at - 1);
  const std::string_view entry = text.part(before == std::string::npos ? 0 : before + 1, at);
  const std::size_t last = entry.find_last_not_of(": ");
  if (last == std::string_view::npos) {
    return {};
  }
  const std::string_view words = entry.substr(0, last + 1);
  const std::string_view key = words.substr(words.find_last_of(' ') + 1);
  if (text[at] == ':') {
    return fmt::format("write a ',' before '{}'", key);
  }
  const bool is_word = words.find_first_not_of(' ') == words.size() - key.size();
  return is_word && is_one_of(text[at], "[{'\"")
             ? fmt::format("write '{}: ' before it, with a colon and a space", key)
             : std::string();
}

Words words_for(std::string_view parser, const YamlText& text, std::size_t at) {
  const auto* const row = std::ranges::find_if(
      kWords, [&](const Words& one) { return parser.starts_with(one.parser); });
  if (row == kWords.end()) {
    return {};
  }
  if (row->hint != kIndentationHint) {
    return *row;
  }
  if (at > 0 && is_one_of(text[at - 1], "'\"")) {
    return {parser,
            "'{}' follows a closing quote",
            text[at - 1] == '\'' ? "inside '...' an apostrophe is written twice"
                                 : "inside \"...\" a quote is written \\\""};
  }
  if (text[at] == ',') {
    return {parser, "',' is outside of brackets", "remove it: every line is an entry"};
  }
  const std::string word = word_at(text, at);
  return {parser,
          row->message,
          word == "-"             ? kItemHint
          : word.starts_with('-') ? "write a space behind the '-' of an item"
                                  : row->hint};
}

// By what stands around the place; empty where that says no more than the parser.
std::string hint_at(std::string_view parser, const YamlText& text, std::size_t at) {
  return parser.starts_with(kIllegalValue)  ? hint_on_second_colon(text, at)
         : parser.starts_with(kOpenMapping) ? hint_on_entry(text, at)
                                            : std::string();
}

void report_unknown_alias(SourceMap& map, std::size_t at, Diagnostics& found) {
  const std::size_t end = map.text().skip_word(at);
  found.error(
      "E0209",
      map.range(at, end),
      fmt::format("alias '{}' names no anchor before it", word_at(map.text(), at)),
      fmt::format("mark the value as '&{}' before its first use", map.text().part(at + 1, end)));
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
  if (exception.msg.starts_with(kIllegalValue)) {
    const std::size_t key = find_key_without_colon(map.text(), at);
    if (key != std::string::npos) {
      report_key_without_colon(map, key, found);
      return;
    }
  }
  const Words words = words_for(exception.msg, map.text(), at);
  const std::string hint = hint_at(exception.msg, map.text(), at);
  Diagnostic& error = found.error(
      "E0204",
      map.at(at),
      words.message.empty() ? exception.msg
                            : fmt::format(fmt::runtime(words.message), word_at(map.text(), at)),
      hint.empty() ? std::string(words.hint) : hint);
  if (last_long_quote.line > 0) {
    error.notes.push_back({last_long_quote, "the quoted text that begins here goes over lines"});
    error.hint = "close that text where it should end; " + error.hint;
  }
}

}  // namespace kinestat
