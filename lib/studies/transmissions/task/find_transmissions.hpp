// All transmissions for the synthesis task of a description.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "core/diagnostic.hpp"
#include "studies/transmissions/report/transmission_analysis.hpp"

namespace kinestat {

/// How many ladders are listed where nobody says how many.
inline constexpr std::uint64_t kUsualLadders = 20;

struct TransmissionOptions {
  std::uint64_t jobs = 0;                 ///< threads; 0: as many as the machine has cores
  std::optional<std::uint64_t> top;       ///< ladders that are listed
  std::optional<TransmissionRank> rank;   ///< before what the file says
  std::string work = {};                  ///< folder of a stored search; empty: none
  std::optional<SearchShare> share = {};  ///< of a stored search: that share of its structures
  std::function<void(const SearchProgress&)> progress = {};  ///< hears how far it is; may be empty
};

/// The task of a description that is right by itself (check). Empty iff an error was added: E0803.
std::optional<TransmissionTask> read_transmission_task(const MechanismDescription& description,
                                                       Diagnostics& found);

/// Empty iff the task contradicts itself. That nothing was found is an error beside the report.
std::optional<TransmissionAnalysis> find_transmissions(const std::string& path,
                                                       MechanismDescription description,
                                                       const TransmissionOptions& options,
                                                       Diagnostics& found);

}  // namespace kinestat
