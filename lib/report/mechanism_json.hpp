// What every report begins with: program, mechanism, coupling graph.
#pragma once

#include <string>

#include "mechanism/mechanism.hpp"
#include "report/json_values.hpp"

namespace kinestat {

/// The keys "kinestat" and "mechanism". `file` is the path as the user gave it.
Json report_head(const std::string& file, const MechanismDescription& description);

/// The key "graph": bodies, couplings, tree and chords, lengths in the units of the file.
Json graph_json(const Mechanism& mechanism, const FileUnits& units);

}  // namespace kinestat
