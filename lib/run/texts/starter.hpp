// Commented mechanism files to begin with.
#pragma once

#include <string>
#include <vector>

#include "files/outcome.hpp"
#include "io/atomic_file.hpp"

namespace kinestat {

/// "four-bar", "planetary" and so on.
std::vector<std::string> starter_kinds();

/// The starter file of a kind, on standard output or, whole or not at all, in the file `path`. A
/// present file is replaced only when forced.
Outcome write_starter(const std::string& kind, const std::string& path, Overwrite overwrite);

}  // namespace kinestat
