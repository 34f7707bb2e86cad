// The methods of solution, timed and judged on files.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "files/file_options.hpp"
#include "studies/benchmark/interleaved_times.hpp"
#include "studies/benchmark/report/benchmark_report.hpp"

namespace kinestat {

struct BenchmarkChoice {
  std::string case_label;  ///< empty: all
  TimingLimits limits;     ///< of each side of a case
};

/// Of the cases chosen. Empty iff an error was added: there is no such case.
std::optional<std::vector<BenchmarkedCase>> benchmark_cases(const Mechanism& mechanism,
                                                            const BenchmarkChoice& choice,
                                                            const Clock& clock,
                                                            Diagnostics& found);

/// One report a file on standard output. Without a file the built-in networks are taken: near a
/// dead point, a long train, many planets.
Outcome benchmark_files(const std::vector<std::string>& paths,
                        const BenchmarkChoice& choice,
                        const AnalyseOptions& options,
                        const Clock& clock);

}  // namespace kinestat
