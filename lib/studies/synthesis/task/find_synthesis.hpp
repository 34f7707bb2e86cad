// All linkages for the synthesis task of a description.
#pragma once

#include <optional>
#include <string>

#include "core/diagnostic.hpp"
#include "studies/synthesis/report/synthesis_report.hpp"
#include "studies/synthesis/task/synthesis_options.hpp"

namespace kinestat {

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

}  // namespace kinestat
