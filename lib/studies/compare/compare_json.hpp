// A JSON report as values at their places.
#pragma once

#include <optional>
#include <string_view>

#include "core/diagnostic.hpp"
#include "core/source.hpp"
#include "studies/compare/compare_values.hpp"

namespace kinestat {

/// Reads a report that this program wrote, or another that keeps to its format. Things in a list
/// that have a name stand under their name, and so do the names of a list of names, but for the
/// bodies of a coupling and the labels of a matrix, whose order matters. Left out is what differs
/// between two runs of the same: version, path of the file, evidence and residuals, wording; of the
/// diagnostics remains how often each code occurs. Errors: E0903 for what is no report, E0904 for
/// one of another version of the format. Empty iff an error was added.
/// The text is let go as soon as it is read as JSON: with the values it would be the largest part.
std::optional<ReportValues> read_json_report(SourceFile& source, Diagnostics& found);

/// Whether the text begins as several reports do, one a line, which commands on several files
/// write.
bool has_reports_in_lines(std::string_view text);

/// Reads them, each below the file that it is on. Errors as above, at their lines.
std::optional<ReportValues> read_json_reports(const SourceFile& source, Diagnostics& found);

}  // namespace kinestat
