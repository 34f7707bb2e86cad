#include "run/outcome.hpp"

#include <fmt/format.h>

#include "core/codes.hpp"
#include "report/diagnostic_text.hpp"

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

void add_diagnostics(const SourceFile& source,
                     const Diagnostics& found,
                     Strictness strictness,
                     Outcome& outcome) {
  outcome.err += diagnostics_text(source, found);
  outcome.status = worst(outcome.status, status_of(found, strictness));
}

void add_bug(const std::string& path, std::string_view what, Outcome& outcome) {
  outcome.err += fmt::format(
      "{}: internal error: {}\n  hint: this is a bug of kinestat; please report it with the file\n",
      path,
      what);
  outcome.status = worst(outcome.status, ExitStatus::bug);
}

}  // namespace kinestat
