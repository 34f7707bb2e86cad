#include "files/outcome.hpp"

#include <set>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "core/codes.hpp"
#include "report/diagnostics/diagnostic_json.hpp"
#include "report/diagnostics/diagnostic_text.hpp"

namespace kinestat {

ExitStatus status_of(const Diagnostics& found, Strictness strictness) {
  ExitStatus status = ExitStatus::done;
  for (const Diagnostic& one : found.items()) {
    status = worst(status, find_code(one.code)->status);
    if (strictness == Strictness::strict && one.severity == Severity::warning) {
      status = worst(status, ExitStatus::check_failed);
    }
  }
  return status;
}

std::string standard_output(const Outcome& outcome, const TextLayout& layout) {
  return outcome.out + outcome.report.text(layout);
}

std::string standard_error(const Outcome& outcome, const TextLayout& layout) {
  const std::string text = layout.is_coloured ? outcome.err.coloured() : outcome.err.plain();
  return outcome.form == DiagnosticsForm::sarif ? text + sarif_log(outcome.results, outcome.status)
                                                : text;
}

void add_new(const Diagnostics& more, Diagnostics& found) {
  const auto key = [](const Diagnostic& one) {
    return std::tuple(one.where.line, one.where.column, one.code, one.message);
  };
  std::set<std::tuple<int, int, std::string_view, std::string>> known;
  for (const Diagnostic& one : found.items()) {
    known.insert(key(one));
  }
  for (const Diagnostic& one : more.items()) {
    if (!known.insert(key(one)).second) {
      continue;
    }
    Diagnostic& added = one.severity == Severity::error
                            ? found.error(one.code, one.where, one.message, one.hint)
                            : found.warning(one.code, one.where, one.message, one.hint);
    added.notes = one.notes;
  }
}

void add_diagnostics(const SourceFile& source,
                     const Diagnostics& found,
                     Strictness strictness,
                     Outcome& outcome) {
  const ExitStatus status = status_of(found, strictness);
  switch (outcome.form) {
    case DiagnosticsForm::text:
      outcome.err += diagnostics_text(source, found);
      break;
    case DiagnosticsForm::json:
      outcome.err += diagnostics_line(source, found, status);
      break;
    case DiagnosticsForm::sarif:
      add_results(source, found, outcome.results);
      break;
  }
  outcome.status = worst(outcome.status, status);
}

void tell(const StyledText& text, Outcome& outcome) {
  if (outcome.form == DiagnosticsForm::text) {
    outcome.err += text;
  }
}

void add_message(std::string_view code, std::string message, std::string hint, Outcome& outcome) {
  Diagnostics found;
  found.error(code, {}, std::move(message), std::move(hint));
  add_diagnostics({}, found, Strictness::normal, outcome);
}

void add_bug(std::string_view what, Diagnostics& found) {
  found.error("E0155",
              {},
              fmt::format("internal error: {}", what),
              "this is a bug of kinestat; please report it with the file");
}

void add_bug(const std::string& path, std::string_view what, Outcome& outcome) {
  Diagnostics found;
  add_bug(what, found);
  add_diagnostics({.path = path, .text = {}}, found, Strictness::normal, outcome);
}

}  // namespace kinestat
