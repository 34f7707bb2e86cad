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

}  // namespace kinestat
