// The main job: files through the passes they ask for, to reports.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/analysis.hpp"
#include "cases/solve_cases.hpp"
#include "files/file_options.hpp"

namespace kinestat {

/// Analyses every file; one that fails does not stop the others. JSON of several files is one
/// object a line.
Outcome analyse_files(const std::vector<std::string>& paths, const AnalyseOptions& options);

/// The report that `analyze` makes of a file that was read; adds the findings. Empty if the
/// description is wrong; one that is right, but has no mechanism or holds something that decides
/// and is not analysed yet, has a report that says so.
std::optional<FileReport> analyse_description(const std::string& path,
                                              MechanismDescription description,
                                              const AccuracyRequest& accuracy,
                                              const ReportForms& forms,
                                              Diagnostics& found);

/// All that `analyze` finds of a mechanism that was bound, its gears included; adds the findings.
/// Empty iff an error of the shift section was added.
std::optional<CertifiedAnalysis> analyse_mechanism(const std::string& path,
                                                   Loaded loaded,
                                                   const AccuracyRequest& accuracy,
                                                   Diagnostics& found);

/// Reads and binds every file; says "ok" for each that is well-formed.
Outcome check_files(const std::vector<std::string>& paths, const AnalyseOptions& options);

}  // namespace kinestat
