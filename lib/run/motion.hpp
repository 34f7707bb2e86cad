// Finite motions of the mechanisms of files.
#pragma once

#include <string>
#include <vector>

#include "files/file_options.hpp"
#include "studies/motion/task/motion_choice.hpp"

namespace kinestat {

/// Words for what a motion reports, beside the names of the file.
std::vector<std::string> motion_words();

/// One report a file, on standard output or as files. A file without a section `motion` is an
/// error unless the choice names a drive.
Outcome motion_of_files(const std::vector<std::string>& paths,
                        const MotionChoice& choice,
                        const AnalyseOptions& options);

}  // namespace kinestat
