// Linkages for the synthesis tasks of files.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "math/digit_limits.hpp"
#include "report/synthesis_report.hpp"
#include "run/analyse.hpp"

namespace kinestat {

/// Which linkages become mechanism files.
enum class WrittenLinkages {
  usable,  ///< without defect and within the limits
  all
};

struct SynthesisOptions {
  std::optional<int> digits;  ///< of the positions as typed, before what the files say
  WrittenLinkages written = WrittenLinkages::usable;
  bool verifies = false;   ///< moves every linkage as a mechanism, not only those that are written
  std::uint64_t jobs = 0;  ///< threads of a selection; 0: as many as the machine has cores
};

/// Whether the task of a description that is right by itself (check) is one that can be solved: no
/// position contradicts itself, and digits and ranges belong to its number of positions. False iff
/// an error was added.
bool check_synthesis_task(const MechanismDescription& description, Diagnostics& found);

/// All linkages for the task of a description. Empty iff an error was added, as for a file without
/// the section `synthesis`.
std::optional<SynthesisAnalysis> find_synthesis(const std::string& path,
                                                MechanismDescription description,
                                                const SynthesisOptions& options,
                                                Diagnostics& found);

/// One report a file on standard output. A file without the section `synthesis` is an error. Where
/// the options name a folder, linkages are written into it as mechanism files.
Outcome synthesize_files(const std::vector<std::string>& paths,
                         const AnalyseOptions& options,
                         const SynthesisOptions& synthesis);

}  // namespace kinestat
