// What the process returns to the shell.
#pragma once

namespace kinestat {

/// Values are part of the interface. Several files: the largest counts.
enum class ExitStatus : int {
  done = 0,          ///< also with warnings and findings
  check_failed = 1,  ///< done, but a published value was missed, or --strict met a warning
  usage = 2,         ///< the command line
  wrong_input = 3,   ///< the mechanism file, including missing or dependent primaries
  environment = 4,   ///< cannot read or write, disk full, out of memory
  no_answer = 5,     ///< a case that was asked for has no answer
  bug = 70
};

inline ExitStatus worst(ExitStatus a, ExitStatus b) {
  return static_cast<int>(a) >= static_cast<int>(b) ? a : b;
}

}  // namespace kinestat
