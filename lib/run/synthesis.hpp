// Linkages for the synthesis tasks of files.
#pragma once

#include <string>
#include <vector>

#include "run/analyse.hpp"

namespace kinestat {

/// Which linkages become mechanism files.
enum class WrittenLinkages {
  usable,  ///< without defect and within the limits
  all
};

/// One report a file on standard output. A file without the section `synthesis` is an error. Where
/// the options name a folder, linkages are written into it as mechanism files.
Outcome synthesize_files(const std::vector<std::string>& paths,
                         WrittenLinkages written,
                         const AnalyseOptions& options);

}  // namespace kinestat
