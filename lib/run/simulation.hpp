// Simulations of the mechanisms of files.
#pragma once

#include <string>
#include <vector>

#include "files/file_options.hpp"
#include "studies/simulation/report/simulation_record.hpp"
#include "studies/simulation/task/find_simulation.hpp"

namespace kinestat {

/// Refers to all of them.
SimulationReportView simulation_view(const std::string& path,
                                     const MechanismDescription& description,
                                     const FoundSimulation& answer,
                                     const Diagnostics* found);

/// One report a file on standard output, of what `report` names or, if that is empty, the file. A
/// file without a section `simulation` is an error.
Outcome simulate_files(const std::vector<std::string>& paths,
                       const std::vector<std::string>& report,
                       const AnalyseOptions& options);

}  // namespace kinestat
