// The tidy tables of a report as values at their places.
#pragma once

#include <optional>

#include "core/diagnostic.hpp"
#include "core/source.hpp"
#include "studies/compare/compare_values.hpp"

namespace kinestat {

/// Reads a table with the columns of kCsvHeader or kMotionCsvHeader, in any order, its rows in any
/// order. A value stands at /mechanism/case/pass/element/quantity, in a motion at its step below
/// that, the status of its row below. Lines may end
/// with CR LF. Errors, with their line: E0903 for missing or unknown columns, for a value that is
/// no finite number, for a unit that is none, and for two rows with one place. Empty iff an error
/// was added.
std::optional<ReportValues> read_csv_report(const SourceFile& source, Diagnostics& found);

}  // namespace kinestat
