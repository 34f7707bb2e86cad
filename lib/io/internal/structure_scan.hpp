// Brackets, quotes and indentation of a YAML text, looked at before the parser runs.
#pragma once

#include "core/diagnostic.hpp"
#include "io/internal/source_map.hpp"
#include "io/read_file.hpp"

namespace kinestat {

/// Follows the text token by token as yaml-cpp's scanner does, but builds nothing, so that what the
/// parser accepts silently (an unclosed quote), reports at the wrong place (an unclosed bracket, a
/// tab) or pays dearly for (a million brackets) is refused before: E0203, E0204, E0210. Where the
/// parser itself will complain, the scan ends without a word. False iff an error was added.
bool scan_structure(SourceMap& map, const ReadLimits& limits, Diagnostics& found);

}  // namespace kinestat
