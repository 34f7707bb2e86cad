// Every diagnostic code, with its title, its exit status and the paragraph `explain` prints.
#pragma once

#include <span>
#include <string_view>

#include "core/exit_status.hpp"

namespace kinestat {

/// One row: codes are stable; E01 command line and environment, E02 YAML form, E03 mechanism
/// meaning, E04 graph, E05 kinematics, E06 statics, E07 power, E08 synthesis, E09 report. A W code
/// is a warning.
struct Code {
  std::string_view code;
  ExitStatus status = ExitStatus::wrong_input;  ///< what the process returns because of it
  std::string_view title;
  std::string_view paragraph;
};

/// All rows, in the order of their codes.
std::span<const Code> all_codes();

/// The row of a code, or null for an unknown one.
const Code* find_code(std::string_view code);

}  // namespace kinestat
