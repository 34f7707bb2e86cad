#include "io/internal/structure_words.hpp"

#include <fmt/format.h>

namespace kinestat {

void report_depth(const ReadLimits& limits, SourceRange where, Diagnostics& found) {
  found.error("E0210",
              where,
              fmt::format("more than {} levels of nesting", limits.depth),
              "a mechanism file needs fewer than ten");
}

void report_nodes(const ReadLimits& limits, SourceRange where, Diagnostics& found) {
  found.error("E0210",
              where,
              fmt::format("more than {} values in the file, aliases expanded", limits.nodes),
              "split the file, or keep tables elsewhere");
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

void report_tab(SourceMap& map, std::size_t tab, Diagnostics& found) {
  found.error("E0203",
              map.at(tab),
              "tab in the indentation",
              "indent with spaces; most editors can replace all tabs at once");
}

void report_second_document(SourceMap& map, std::size_t begin, Diagnostics& found) {
  if (map.text().is_document_mark(begin)) {
    found.error("E0206",
                map.range(begin, begin + 3),
                "a second document begins here",
                "one file describes one mechanism; remove '---' and what follows it");
  } else {
    found.error("E0204",
                map.at(begin),
                "this stands behind the end of the document",
                "begin every key of the file in the same column");
  }
}

}  // namespace kinestat
