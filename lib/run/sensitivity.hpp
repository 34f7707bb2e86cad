// How the answers of files move with their parameters.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "files/file_options.hpp"
#include "studies/sensitivity/report/sensitivity_report.hpp"

namespace kinestat {

/// What to differentiate; an empty list stands for the usual (usual_value_names) or for all.
struct SensitivityChoice {
  std::vector<std::string> values;      ///< short names, or paths of the report below a case
  std::vector<std::string> parameters;  ///< names
  std::string case_label;               ///< empty: all cases
};

/// What was found of one file.
struct FoundSensitivity {
  std::vector<SensitivityParameter> parameters;
  std::vector<CaseSensitivity> cases;
};

/// Empty iff an error was added.
std::optional<FoundSensitivity> find_sensitivity(const Analysis& analysis,
                                                 const SensitivityChoice& choice,
                                                 Diagnostics& found);

/// One report a file on standard output.
Outcome sensitivity_files(const std::vector<std::string>& paths,
                          const SensitivityChoice& choice,
                          const AnalyseOptions& options);

}  // namespace kinestat
