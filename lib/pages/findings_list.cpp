#include <algorithm>
#include <string_view>

#include "pages/page_parts.hpp"
#include "report/diagnostics/diagnostic_text.hpp"

namespace kinestat {

namespace {

// Whether a finding goes on with "   12 | ..." or "      | ^^^".
bool is_quotation(std::string_view text) {
  const std::size_t mark = text.find_first_not_of(" 0123456789");
  return mark != std::string_view::npos && text.substr(mark).starts_with('|');
}

void add_finding(std::string_view text, Html& html) {
  while (!text.empty()) {
    const bool is_quoted = is_quotation(text);
    std::size_t end = 0;
    while (end < text.size() && is_quotation(text.substr(end)) == is_quoted) {
      end = std::min(text.find('\n', end), text.size() - 1) + 1;
    }
    if (is_quoted) {  // may be wider than a telephone, and must not be broken
      html.open("pre", {{"class", "quoted"}, {"tabindex", "0"}});
    } else {
      html.open("pre", {{"class", "words"}});
    }
    html.lines(text.substr(0, end));
    html.close();
    text.remove_prefix(end);
  }
}

}  // namespace

void add_findings(const SourceFile& source, const Diagnostics& found, Html& html) {
  html.open("ul", {{"class", "findings"}});
  for (const DiagnosticText& one : diagnostic_texts(source, found)) {
    html.open("li", {{"class", one.severity == Severity::error ? "error" : "warning"}});
    add_finding(one.text.plain(), html);
    html.close();
  }
  html.close();
}

}  // namespace kinestat
