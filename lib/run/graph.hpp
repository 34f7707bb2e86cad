// The coupling graph of files, with the matrices of the method on request.
#pragma once

#include <string>
#include <vector>

#include "files/file_options.hpp"

namespace kinestat {

enum class Matrices { none, all };

/// One report a file on standard output, numbers in the units of the file. With all matrices, the
/// partition is that of the case named, or of the first one.
Outcome graph_files(const std::vector<std::string>& paths,
                    Matrices matrices,
                    const std::string& case_label,
                    const AnalyseOptions& options);

}  // namespace kinestat
