// Published values against the report.
#pragma once

#include <vector>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "report/json_values.hpp"
#include "report/partial_archive.hpp"

namespace kinestat {

/// On the way to these values.
WantedKeys keys_of(const std::vector<PublishedValue>& published);

/// Adds an error for every value that the report misses by more than its tolerance (E0901), and for
/// every pointer that leads to no number (E0902). The report may be as partial as keys_of allows.
void check_published(const Json& report,
                     const MechanismDescription& description,
                     Diagnostics& found);

}  // namespace kinestat
