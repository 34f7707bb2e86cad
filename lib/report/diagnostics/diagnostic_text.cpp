#include "report/diagnostics/diagnostic_text.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>
#include <tuple>

#include <fmt/format.h>

#include "core/utf8.hpp"

namespace kinestat {

namespace {

constexpr int kMostDiagnostics = 20;
constexpr std::size_t kLongestLine = 160;

// The line of the file without its end; empty for a line that does not exist.
std::string_view line_of(std::string_view text, int number) {
  for (int i = 1; i < number; ++i) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) {
      return {};
    }
    text.remove_prefix(end + 1);
  }
  std::string_view line = text.substr(0, text.find('\n'));
  if (line.ends_with('\r')) {
    line.remove_suffix(1);
  }
  if (number == 1 && line.starts_with("\xEF\xBB\xBF")) {
    line.remove_prefix(3);
  }
  return line;
}

// What stands below some characters of a line: spaces up to the first, carets below the others.
// Tabs stay tabs, and wide characters have two, so that carets stand below their places.
std::string marks_below(std::string_view line, int column, int length) {
  std::string spaces;
  std::string carets;
  int number = 1;
  for (std::size_t at = 0; at < line.size() && number < column + length; ++number) {
    const Character next = character_at(line, at);
    const std::size_t width = columns_of(next.code);
    if (number < column) {
      spaces += next.code == '\t' ? std::string("\t") : std::string(width, ' ');
    } else {
      carets += std::string(width, '^');
    }
    at += std::max<std::size_t>(next.size, 1);
  }
  if (number < column) {  // behind the end of the line
    spaces += std::string(static_cast<std::size_t>(column - number), ' ');
  }
  return spaces + (carets.empty() ? "^" : carets);
}

// Whether a terminal may show the characters in another order than they stand.
bool is_reordered(std::string_view line) {
  constexpr auto kMarks = std::to_array<std::string_view>(
      {"\u202A", "\u202B", "\u202C", "\u202D", "\u202E", "\u2066", "\u2067", "\u2068", "\u2069"});
  return std::ranges::any_of(
      kMarks, [line](std::string_view mark) { return line.find(mark) != line.npos; });
}

LineStyle style_of(Severity severity) {
  return severity == Severity::error ? LineStyle::error : LineStyle::warning;
}

StyledText excerpt(const SourceFile& source, const SourceRange& where, LineStyle style) {
  const std::string_view line = line_of(source.text, where.line);
  const bool can_be_shown = !line.empty() && line.size() <= kLongestLine &&
                            !find_bad_character(line) && !is_reordered(line);
  StyledText text;
  if (where.line != 0 && can_be_shown) {
    text += fmt::format("{:5} | {}\n      | ", where.line, line);
    text.add(marks_below(line, where.column, std::clamp(where.length, 1, 100)), style);
    text += "\n";
  }
  return text;
}

std::string place(const SourceFile& source, const SourceRange& where) {
  const std::string path = source.path.empty()  ? "kinestat"
                           : source.path == "-" ? "<stdin>"
                                                : printable(source.path);
  return where.line == 0 ? path : fmt::format("{}:{}:{}", path, where.line, where.column);
}

StyledText text_of(const SourceFile& source, const Diagnostic& one) {
  const LineStyle style = style_of(one.severity);
  StyledText text;
  text.add(place(source, one.where) + ":", LineStyle::heading);
  text += " ";
  text.add(fmt::format("{}[{}]:", one.severity == Severity::error ? "error" : "warning", one.code),
           style);
  text += fmt::format(" {}\n", one.message);
  text += excerpt(source, one.where, style);
  for (const Note& note : one.notes) {
    text.add(place(source, note.where) + ": note:", LineStyle::heading);
    text += fmt::format(" {}\n", note.message);
    text += excerpt(source, note.where, LineStyle::hint);
  }
  if (!one.hint.empty()) {
    text += "  ";
    text.add("hint:", LineStyle::hint);
    text += fmt::format(" {}\n", one.hint);
  }
  return text;
}

}  // namespace

std::vector<Diagnostic> by_place(const Diagnostics& found) {
  std::vector<Diagnostic> sorted(found.items().begin(), found.items().end());
  std::ranges::stable_sort(sorted, {}, [](const Diagnostic& one) {
    const int line = one.where.line == 0 ? std::numeric_limits<int>::max() : one.where.line;
    return std::tuple(line, one.where.column);
  });
  return sorted;
}

std::vector<DiagnosticText> diagnostic_texts(const SourceFile& source, const Diagnostics& found) {
  std::vector<DiagnosticText> texts;
  int errors = 0;
  int warnings = 0;
  for (const Diagnostic& one : by_place(found)) {
    int& count = one.severity == Severity::error ? errors : warnings;
    if (++count <= kMostDiagnostics) {
      texts.push_back({.severity = one.severity, .text = text_of(source, one)});
    }
  }
  const auto add_rest = [&](Severity severity, int count, std::string_view what) {
    if (count > kMostDiagnostics) {
      texts.push_back({.severity = severity,
                       .text = fmt::format(
                           "{}: {} more {}\n", place(source, {}), count - kMostDiagnostics, what)});
    }
  };
  add_rest(Severity::error, errors, "errors");
  add_rest(Severity::warning, warnings, "warnings");
  return texts;
}

StyledText diagnostics_text(const SourceFile& source, const Diagnostics& found) {
  StyledText text;
  for (const DiagnosticText& one : diagnostic_texts(source, found)) {
    text += one.text;
  }
  return text;
}

}  // namespace kinestat
