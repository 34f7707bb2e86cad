// Diagnostics as text for a terminal, with the line and a caret.
#pragma once

#include <string>

#include "core/diagnostic.hpp"
#include "core/source.hpp"

namespace kinestat {

/// All messages of one file: the first line of each is `path:line:column: error[E0312]: message`,
/// which editors parse; then the line of the file with carets, notes and the hint. At most 20
/// errors and 20 warnings; then a count.
std::string diagnostics_text(const SourceFile& source, const Diagnostics& found);

}  // namespace kinestat
