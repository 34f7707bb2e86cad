// Diagnostics as text for a terminal, with the line and a caret.
#pragma once

#include <vector>

#include "core/diagnostic.hpp"
#include "core/source.hpp"
#include "report/styled_text.hpp"

namespace kinestat {

/// The messages in the order of the file, those about the whole file last.
std::vector<Diagnostic> by_place(const Diagnostics& found);

/// A message as it stands on a terminal, on several lines.
struct DiagnosticText {
  Severity severity = Severity::error;
  StyledText text;
};

/// What diagnostics_text puts together.
std::vector<DiagnosticText> diagnostic_texts(const SourceFile& source, const Diagnostics& found);

/// All messages of one file by place: the first line of each is `path:line:column: error[E0312]:
/// message`, which editors parse; then the line of the file with carets, notes and the hint. At
/// most 20 errors and 20 warnings; then a count. An empty path stands for the program itself.
StyledText diagnostics_text(const SourceFile& source, const Diagnostics& found);

}  // namespace kinestat
