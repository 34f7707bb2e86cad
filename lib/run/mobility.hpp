// How free mechanisms are, and what is redundant in them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "files/file_options.hpp"
#include "studies/mobility/report/mobility_report.hpp"

namespace kinestat {

/// How free the mechanism of a description is. Empty iff an error was added.
std::optional<MobilityAnalysis> find_mobility(const std::string& path,
                                              MechanismDescription description,
                                              const AccuracyRequest& accuracy,
                                              Diagnostics& found);

/// One report a file on standard output. A file without dimensions is counted.
Outcome mobility_of_files(const std::vector<std::string>& paths, const AnalyseOptions& options);

}  // namespace kinestat
