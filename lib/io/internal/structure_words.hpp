// What both the scan of the structure and the builder of the tree may have to say.
#pragma once

#include "core/diagnostic.hpp"
#include "io/internal/source_map.hpp"
#include "io/read_file.hpp"

namespace kinestat {

/// Adds E0210 for too many levels of nesting.
void report_depth(const ReadLimits& limits, SourceRange where, Diagnostics& found);

/// Adds E0210 for too many values.
void report_nodes(const ReadLimits& limits, SourceRange where, Diagnostics& found);

/// Adds E0204 for the quote at the offset, which nothing closes.
void report_open_quote(SourceMap& map, std::size_t quote, Diagnostics& found);

}  // namespace kinestat
