// Diagnostics as JSON for editors and scripts.
#pragma once

#include <string>

#include "core/diagnostic.hpp"
#include "core/exit_status.hpp"
#include "core/source.hpp"
#include "record/record.hpp"

namespace kinestat {

/// What is said of one file.
struct DiagnosticsLineView {
  const SourceFile& source;
  const Diagnostics& found;
  ExitStatus status;
};

const Record<DiagnosticsLineView>& diagnostics_line_record();

/// One line for one file, with all its messages, also when there are none; the status is that of
/// this file alone. An empty path stands for the program itself: its "file" is null. The line is
/// ASCII and strict JSON; what is no printable character in a path or a text stands as \xNN.
std::string diagnostics_line(const SourceFile& source, const Diagnostics& found, ExitStatus status);

}  // namespace kinestat
