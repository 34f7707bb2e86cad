// What a command has to say at its end: text for both streams and the exit status.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "core/diagnostic.hpp"
#include "core/exit_status.hpp"
#include "core/source.hpp"
#include "report/diagnostics/diagnostic_sarif.hpp"
#include "report/styled_text.hpp"
#include "report/text_blocks.hpp"

namespace kinestat {

enum class Strictness { normal, strict };

/// How messages are written to standard error.
enum class DiagnosticsForm {
  text,  ///< for a terminal: place, message, the line of the file, hint
  json,  ///< for editors and scripts: one line a file, by schemas/diagnostics.schema.json
  sarif  ///< for code hosts: one log of all files, at the end
};

/// The words for them.
inline constexpr std::array<std::pair<std::string_view, DiagnosticsForm>, 3> kDiagnosticsForms = {
    {{"text", DiagnosticsForm::text},
     {"json", DiagnosticsForm::json},
     {"sarif", DiagnosticsForm::sarif}}};

/// The library prints nothing itself.
struct Outcome {
  std::string out;         ///< for standard output
  TextBlocks report = {};  ///< likewise, behind it: laid out for what shows it
  StyledText err = {};     ///< for standard error, before the log
  ExitStatus status = ExitStatus::done;
  DiagnosticsForm form = DiagnosticsForm::text;  ///< of messages
  SarifResults results = {};                     ///< of the log, in that form
};

/// What belongs on standard output, laid out.
std::string standard_output(const Outcome& outcome, const TextLayout& layout);

/// What belongs on standard error, with the log.
std::string standard_error(const Outcome& outcome, const TextLayout& layout);

/// The exit status that the diagnostics ask for: that of the worst code; with `strict`, warnings
/// count as a failed check.
ExitStatus status_of(const Diagnostics& found, Strictness strictness);

/// Adds to `found` what it does not say yet: every pass reads the description anew, and says again
/// what is wrong with it.
void add_new(const Diagnostics& more, Diagnostics& found);

/// Appends the diagnostics of one file, in the form of the outcome, and their status. As JSON a
/// file without messages has its line too.
void add_diagnostics(const SourceFile& source,
                     const Diagnostics& found,
                     Strictness strictness,
                     Outcome& outcome);

/// Appends what people like to know beside the answer, such as counts; forms for machines have it
/// not.
void tell(const StyledText& text, Outcome& outcome);

/// Appends one error of the program itself, such as a wrong command line.
void add_message(std::string_view code, std::string message, std::string hint, Outcome& outcome);

/// What to say when a contract inside the program was broken.
void add_bug(std::string_view what, Diagnostics& found);

/// The same while a file was processed.
void add_bug(const std::string& path, std::string_view what, Outcome& outcome);

}  // namespace kinestat
