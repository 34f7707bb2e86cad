// What yaml-cpp's parser complains about, in words that help the writer of the file.
#pragma once

#include <yaml-cpp/exceptions.h>

#include "core/diagnostic.hpp"
#include "io/internal/source_map.hpp"

namespace kinestat {

/// Adds the error for an exception of the parser: E0204 as a rule, E0209 for an alias. A quoted
/// text of several lines before it (line 0: none) is cited, because a forgotten quote shows up only
/// later.
void report_parser_error(const YAML::Exception& exception,
                         SourceMap& map,
                         SourceRange last_long_quote,
                         Diagnostics& found);

}  // namespace kinestat
