// What is wrong with a file, as a list.
#pragma once

#include "core/diagnostic.hpp"
#include "core/source.hpp"
#include "pages/html.hpp"

namespace kinestat {

/// As on a terminal; words are broken into lines, the line of the file with its carets is not.
void add_findings(const SourceFile& source, const Diagnostics& found, Html& html);

}  // namespace kinestat
