// A report in either of its forms as values.
#pragma once

#include <optional>

#include "core/diagnostic.hpp"
#include "core/source.hpp"
#include "studies/compare/compare_values.hpp"

namespace kinestat {

/// Reads JSON or a table, as the text begins. E0903 and E0904 as read_json_report and
/// read_csv_report say; empty iff an error was added.
std::optional<ReportValues> read_report(const SourceFile& source, Diagnostics& found);

}  // namespace kinestat
