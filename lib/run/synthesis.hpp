// Linkages for the synthesis tasks of files.
#pragma once

#include <string>
#include <vector>

#include "run/analyse.hpp"

namespace kinestat {

/// One report a file on standard output. A file without the section `synthesis` is an error.
Outcome synthesize_files(const std::vector<std::string>& paths, const AnalyseOptions& options);

}  // namespace kinestat
