// What a shell reads to complete the words of a command line.
#pragma once

#include <string>
#include <string_view>

#include "files/outcome.hpp"

namespace kinestat {

/// The word in place of a shell with which the scripts ask the program itself for candidates:
/// `kinestat completion candidates -- WORD...`, the last word being the one that is typed.
inline constexpr std::string_view kCandidates = "candidates";

/// The script for that shell, or which shells there are.
Outcome completion_script(const std::string& shell);

}  // namespace kinestat
