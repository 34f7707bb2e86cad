// What a command has to say at its end: text for both streams and the exit status.
#pragma once

#include <string>
#include <string_view>

#include "core/diagnostic.hpp"
#include "core/exit_status.hpp"
#include "core/source.hpp"

namespace kinestat {

/// The library prints nothing itself.
struct Outcome {
  std::string out;  ///< for standard output
  std::string err;  ///< for standard error
  ExitStatus status = ExitStatus::done;
};

enum class Strictness { normal, strict };

/// The exit status that the diagnostics ask for: that of the worst code; with `strict`, warnings
/// count as a failed check.
ExitStatus status_of(const Diagnostics& found, Strictness strictness);

/// Appends the diagnostics as text and their status.
void add_diagnostics(const SourceFile& source,
                     const Diagnostics& found,
                     Strictness strictness,
                     Outcome& outcome);

/// What to say when a contract inside the program was broken while a file was processed.
void add_bug(const std::string& path, std::string_view what, Outcome& outcome);

}  // namespace kinestat
