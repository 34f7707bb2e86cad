#include "io/internal/structure_words.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "io/internal/text_line.hpp"

namespace kinestat {

namespace {

// The mark "..." before the offset, or npos.
std::size_t find_document_end(const YamlText& text, std::size_t before) {
  std::size_t at = text.all().rfind("...", before);
  while (at != std::string::npos && at > 0 && !text.is_document_mark(at)) {
    at = text.all().rfind("...", at - 1);
  }
  return at != std::string::npos && text.is_document_mark(at) ? at : std::string::npos;
}

// The value before the offset, from behind the last ': ' of its line on; empty if brackets are in
// it, or a comment.
std::string_view plain_value_before(const YamlText& text, std::size_t end) {
  const std::size_t mark = text.all().rfind(": ", end);
  if (mark == std::string::npos) {
    return {};
  }
  const std::string_view value = text.part(text.skip_blanks(mark + 1), end);
  return value.find_first_of("[]{}#\n") == std::string_view::npos ? value : std::string_view();
}

}  // namespace

void report_depth(const ReadLimits& limits, SourceRange where, Diagnostics& found) {
  found.error("E0210",
              where,
              fmt::format("more than {} levels of nesting", limits.depth),
              "a mechanism file needs fewer than ten");
}

void report_nodes(const ReadLimits& limits, SourceRange where, Excess excess, Diagnostics& found) {
  found.error("E0210",
              where,
              fmt::format("more than {} values in the file, aliases expanded", limits.nodes),
              excess == Excess::by_alias
                  ? "an alias stands for all values that it names; repeat fewer of them"
                  : "split the file, or keep tables elsewhere; --max-file-size 100M reads more");
}

void report_open_quote(SourceMap& map, std::size_t quote, Diagnostics& found) {
  const bool is_single = map.text()[quote] == '\'';
  found.error("E0204",
              map.range(quote, std::string::npos),
              "the quoted text that begins here is not closed",
              is_single ? "add the closing '; inside '...' an apostrophe is written twice"
                        : "add the closing \"; inside \"...\" a quote is written \\\"");
}

void report_open_bracket(SourceMap& map, std::size_t bracket, std::size_t end, Diagnostics& found) {
  const char opening = map.text()[bracket];
  Diagnostic& error =
      found.error("E0204",
                  map.at(bracket),
                  fmt::format("'{}' is not closed", opening),
                  fmt::format("add the '{}' that belongs to it", opening == '[' ? ']' : '}'));
  if (!map.text().is_end(end)) {
    error.notes.push_back({map.at(end), fmt::format("'{}' stands here", map.text()[end])});
  }
}

void report_wrong_bracket(SourceMap& map,
                          std::span<const std::size_t> open,
                          std::size_t end,
                          Diagnostics& found) {
  const char fitting = map.text()[end] == ']' ? '[' : '{';
  const auto fits = [&](std::size_t bracket) { return map.text()[bracket] == fitting; };
  if (std::ranges::any_of(open, fits)) {
    report_open_bracket(map, open.back(), end, found);
    return;
  }
  const char opening = map.text()[open.back()];
  const char wanted = opening == '[' ? ']' : '}';
  const std::string_view value = fitting == '[' ? plain_value_before(map.text(), end) : "";
  found
      .error("E0204",
             map.at(end),
             fmt::format("'{}' cannot close '{}'", map.text()[end], opening),
             value.empty() ? fmt::format("remove it, or write '{}' in its place", wanted)
                           : fmt::format("write [{}], or remove it", value))
      .notes.push_back({map.at(open.back()), fmt::format("'{}' is open since here", opening)});
}

void report_loose_bracket(SourceMap& map, std::size_t bracket, Diagnostics& found) {
  const YamlText& text = map.text();
  // "a: type: revolute, at: [0, 0]}"
  const std::size_t value = find_value(text, line_at(text, bracket).content);
  const bool is_key = value != std::string::npos && find_value(text, value) < bracket;
  found.error("E0204",
              map.at(bracket),
              fmt::format("'{}' closes nothing", text[bracket]),
              is_key && text[bracket] == '}'
                  ? fmt::format("write the '{{' that belongs to it before '{}', or remove it",
                                text.part(value, skip_key(text, value)))
                  : "remove it, or quote a text that begins with it");
}

void report_tab(SourceMap& map, std::size_t tab, Diagnostics& found) {
  found.error("E0203",
              map.at(tab),
              "tab in the indentation",
              "indent with spaces; most editors can replace all tabs at once");
}

void report_second_document(SourceMap& map,
                            std::size_t begin,
                            SourceRange root,
                            Diagnostics& found) {
  if (map.text().is_document_mark(begin)) {
    found.error("E0206",
                map.range(begin, begin + 3),
                "a second document begins here",
                "one file describes one mechanism; remove '---' and what follows it");
    return;
  }
  const std::size_t end = find_document_end(map.text(), begin);
  Diagnostic& error = found.error(
      "E0204",
      map.at(begin),
      "this follows the end of the document",
      end == std::string::npos ? "begin every key of the file in the same column" : "remove '...'");
  if (end != std::string::npos) {
    error.notes.push_back({map.range(end, end + 3), "the document ends here"});
  } else {
    error.notes.push_back({root, "the document begins here"});
  }
}

}  // namespace kinestat
