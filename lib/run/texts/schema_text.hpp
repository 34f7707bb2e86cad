// The schemas of the files that this program reads and writes.
#pragma once

#include <string>
#include <vector>

#include "files/outcome.hpp"

namespace kinestat {

/// Those that there are, in the order of the alphabet.
std::vector<std::string> schema_names();

/// The JSON Schema "mechanism", "report", "comparison" or "diagnostics", as the file in schemas/,
/// byte for byte.
Outcome schema_text(const std::string& name);

}  // namespace kinestat
