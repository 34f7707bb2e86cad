// Simulations of the mechanisms of files.
#pragma once

#include <string>
#include <vector>

#include "files/file_options.hpp"

namespace kinestat {

/// One report a file on standard output. A file without a section `simulation` is an error.
Outcome simulate_files(const std::vector<std::string>& paths, const AnalyseOptions& options);

}  // namespace kinestat
