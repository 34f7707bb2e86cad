// How free mechanisms are, and what is redundant in them.
#pragma once

#include <string>
#include <vector>

#include "run/analyse.hpp"

namespace kinestat {

/// One report a file on standard output. A file without dimensions is counted.
Outcome mobility_of_files(const std::vector<std::string>& paths, const AnalyseOptions& options);

}  // namespace kinestat
