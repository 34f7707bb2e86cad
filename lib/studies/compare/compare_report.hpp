// A report in either of its forms as values.
#pragma once

#include <optional>

#include "core/diagnostic.hpp"
#include "core/source.hpp"
#include "studies/compare/compare_values.hpp"

namespace kinestat {

/// Reads JSON, a table or the rows of a sweep, as the text begins. E0903 and E0904 as
/// read_json_report, read_csv_report and read_sweep_rows say; empty iff an error was added. Of the
/// text remains what the places of errors need.
std::optional<ReportValues> read_report(SourceFile& source, Diagnostics& found);

}  // namespace kinestat
