// The main job: files through the passes they ask for, to reports.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/accuracy.hpp"
#include "run/certified_cases.hpp"
#include "run/load.hpp"
#include "run/outcome.hpp"
#include "run/output.hpp"

namespace kinestat {

/// What goes to standard output.
enum class StreamFormat { table, json, csv };

struct AnalyseOptions {
  LoadOptions load;
  StreamFormat format = StreamFormat::table;
  OutputOptions output;
  Strictness strictness = Strictness::normal;
  DiagnosticsForm diagnostics = DiagnosticsForm::text;
  AccuracyRequest accuracy{.accuracy = Accuracy::automatic};
  bool is_quiet = false;   ///< no table on standard output
  bool fail_fast = false;  ///< stop after the first file that fails
};

/// Analyses every file; one that fails does not stop the others. JSON of several files is one
/// object a line.
Outcome analyse_files(const std::vector<std::string>& paths, const AnalyseOptions& options);

/// All that `analyze` finds of a mechanism that was bound, its gears included; adds the findings.
/// Empty iff an error of the shift section was added.
std::optional<CertifiedAnalysis> analyse_mechanism(const std::string& path,
                                                   Loaded loaded,
                                                   const AccuracyRequest& accuracy,
                                                   Diagnostics& found);

/// Reads and binds every file; says "ok" for each that is well-formed.
Outcome check_files(const std::vector<std::string>& paths, const AnalyseOptions& options);

}  // namespace kinestat
