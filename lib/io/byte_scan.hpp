// What the bytes of a text must satisfy before a parser may see them.
#pragma once

#include "core/diagnostic.hpp"
#include "core/source.hpp"

namespace kinestat {

/// Checks the bytes of a file: UTF-8 (E0202) without control characters (E0203). A byte order mark
/// at the beginning is accepted; UTF-16 is recognised and named. Reports the first fault only,
/// because what follows it is rarely text. False iff an error was added.
bool scan_bytes(const SourceFile& source, Diagnostics& found);

}  // namespace kinestat
