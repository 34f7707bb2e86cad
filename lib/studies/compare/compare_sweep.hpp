// The rows of a sweep as values at their places.
#pragma once

#include <optional>
#include <string_view>

#include "core/diagnostic.hpp"
#include "core/source.hpp"
#include "studies/compare/compare_values.hpp"

namespace kinestat {

/// Whether the text begins as a sweep writes its rows: with their titles, or with a row as a JSON
/// object on one line.
bool begins_with_rows(std::string_view text);

/// Reads the rows, wide CSV or one JSON object a line, in any order. A value stands at
/// /state/case/quantity, where the state is "L = 0.02 m, N = 31": what is varied, in SI, to 12
/// digits. Errors, with their line: E0903 for a row that does not fit its titles, for a value that
/// is no finite number, for a unit that is none, and for two rows with one place. Empty iff an
/// error was added.
std::optional<ReportValues> read_sweep_rows(const SourceFile& source, Diagnostics& found);

}  // namespace kinestat
