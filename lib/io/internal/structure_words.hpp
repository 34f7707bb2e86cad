// What the scan of the structure and the builder of the tree may have to say.
#pragma once

#include <cstddef>
#include <span>

#include "core/diagnostic.hpp"
#include "io/internal/source_map.hpp"
#include "io/read_file.hpp"

namespace kinestat {

/// Adds E0210 for too many levels of nesting.
void report_depth(const ReadLimits& limits, SourceRange where, Diagnostics& found);

/// Who asks for one value too many.
enum class Excess { by_value, by_alias };

/// Adds E0210 for too many values.
void report_nodes(const ReadLimits& limits, SourceRange where, Excess excess, Diagnostics& found);

/// Adds E0204 for the quote at the offset, which nothing closes.
void report_open_quote(SourceMap& map, std::size_t quote, Diagnostics& found);

/// Adds E0204 for the bracket at the offset, open where the text ends or, at `end`, another closes.
void report_open_bracket(SourceMap& map, std::size_t bracket, std::size_t end, Diagnostics& found);

/// Adds E0204 for the closing bracket at the offset, where none is open.
void report_loose_bracket(SourceMap& map, std::size_t bracket, Diagnostics& found);

/// Adds E0203 for a tab where columns count.
void report_tab(SourceMap& map, std::size_t tab, Diagnostics& found);

/// Adds E0204 for a closing bracket at `end` that does not fit the last of the `open` ones: that
/// one is not closed if an outer one fits, else this one is wrong.
void report_wrong_bracket(SourceMap& map,
                          std::span<const std::size_t> open,
                          std::size_t end,
                          Diagnostics& found);

/// Adds E0206 for the document that begins at the offset; E0204 where no mark announces it. `root`
/// is where the first document begins.
void report_second_document(SourceMap& map,
                            std::size_t begin,
                            SourceRange root,
                            Diagnostics& found);

}  // namespace kinestat
