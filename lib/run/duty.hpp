// What a duty asks of the mechanisms of files.
#pragma once

#include <string>
#include <vector>

#include "files/file_options.hpp"

namespace kinestat {

/// One report a file on standard output; `table`, unless empty, is the path of a table of points
/// that stands for those of the section. A file without a section `duty` is an error without it.
Outcome duty_of_files(const std::vector<std::string>& paths,
                      const std::string& table,
                      const AnalyseOptions& options);

}  // namespace kinestat
