// Two reports against each other.
#pragma once

#include <string>

#include "files/file_options.hpp"
#include "files/outcome.hpp"
#include "studies/compare/compare_tolerance.hpp"

namespace kinestat {

struct CompareOptions {
  ToleranceTexts tolerances;
  StreamFormat format = StreamFormat::table;  ///< table or json
  DiagnosticsForm diagnostics = DiagnosticsForm::text;
  bool is_quiet = false;  ///< nothing on standard output
};

/// The keys that are not compared, in indented lines.
std::string ignored_keys_help();

/// Compares the reports in two files, "-" being standard input. The status is check_failed if they
/// differ, wrong_input if one is no report, environment if one cannot be read.
Outcome compare_reports(const std::string& path_a,
                        const std::string& path_b,
                        const CompareOptions& options);

}  // namespace kinestat
