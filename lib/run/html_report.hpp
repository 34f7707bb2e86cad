// The page that shows everything of some files.
#pragma once

#include <string>
#include <vector>

#include "files/file_options.hpp"
#include "io/atomic_file.hpp"

namespace kinestat {

struct HtmlReportOptions {
  std::string path;  ///< of the page; empty: standard output
  Overwrite overwrite = Overwrite::own_only;
};

/// One page for all files, each with every pass for which it gives a reason; a file that is wrong
/// has its findings there. The page is written whole or not at all.
Outcome html_report_of_files(const std::vector<std::string>& paths,
                             const HtmlReportOptions& page,
                             const AnalyseOptions& options);

}  // namespace kinestat
