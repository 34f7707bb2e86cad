// The mechanism files of synthesised linkages.
#pragma once

#include "core/diagnostic.hpp"
#include "files/output.hpp"
#include "studies/synthesis/report/synthesis_report.hpp"
#include "studies/synthesis/task/synthesis_options.hpp"

namespace kinestat {

/// Writes <stem>.linkage_0.yaml, or <stem>.task_0.linkage_0.yaml where the file has lists of angles
/// or ranges, into the folder, all or none, and notes their paths in the tasks. Numbers are those
/// of the report. A file that this program wrote is replaced. False iff an error was added.
bool write_linkages(SynthesisAnalysis& analysis,
                    WrittenLinkages which,
                    const OutputOptions& output,
                    Diagnostics& found);

}  // namespace kinestat
