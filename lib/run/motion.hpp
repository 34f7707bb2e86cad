// Finite motions of the mechanisms of files.
#pragma once

#include <string>
#include <vector>

#include "run/file_options.hpp"
#include "run/internal/motion_choice.hpp"

namespace kinestat {

/// One report a file, on standard output or as files. A file without a section `motion` is an
/// error unless the choice names a drive.
Outcome motion_of_files(const std::vector<std::string>& paths,
                        const MotionChoice& choice,
                        const AnalyseOptions& options);

}  // namespace kinestat
