// Tables with a row a case, a step, a coupling or an entry of a matrix, as values at their places.
#pragma once

#include <optional>
#include <string_view>

#include "core/diagnostic.hpp"
#include "core/source.hpp"
#include "studies/compare/compare_values.hpp"

namespace kinestat {

/// Whether the text begins with the heads of such a table: one of `--layout wide`, or one of the
/// two that the command `graph` writes.
bool begins_with_keyed_rows(std::string_view text);

/// Reads a table that begins so, its rows in any order. A value stands at
/// /mechanism/case/element/quantity, in a motion at /mechanism/case/step 3/element/quantity; at
/// /matrix/row/column/value; at /coupling/type and so on; the file comes first where there is one.
/// Errors, with their line: E0903 for a row that does not fit its heads, for a value that is no
/// finite number, for a unit that is none, and for two rows with one place. Empty iff an error was
/// added.
std::optional<ReportValues> read_keyed_rows(const SourceFile& source, Diagnostics& found);

}  // namespace kinestat
