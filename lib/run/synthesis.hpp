// Linkages and transmissions for the synthesis tasks of files.
#pragma once

#include <string>
#include <vector>

#include "files/file_options.hpp"
#include "studies/synthesis/task/synthesis_options.hpp"
#include "studies/transmissions/task/find_transmissions.hpp"

namespace kinestat {

/// One report a file on standard output. A file without the section `synthesis` is an error. Where
/// the options name a folder, linkages are written into it as mechanism files.
Outcome synthesize_files(const std::vector<std::string>& paths,
                         const AnalyseOptions& options,
                         const SynthesisOptions& synthesis,
                         const TransmissionOptions& transmissions);

}  // namespace kinestat
