// How far positions of files are off where parts and drives are.
#pragma once

#include <string>
#include <vector>

#include "files/file_options.hpp"
#include "studies/tolerance/task/tolerance_choice.hpp"

namespace kinestat {

/// One report a file on standard output.
Outcome tolerance_of_files(const std::vector<std::string>& paths,
                           const ToleranceChoice& choice,
                           const AnalyseOptions& options);

}  // namespace kinestat
