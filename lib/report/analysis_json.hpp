// The report of one file as JSON, by schemas/report.schema.json.
#pragma once

#include "core/diagnostic.hpp"
#include "report/analysis.hpp"
#include "report/json_values.hpp"

namespace kinestat {

/// Everything but the diagnostics. Keys stand in a fixed order; a value that does not exist is
/// null.
Json analysis_json(const Analysis& analysis);

/// The key "diagnostics": severity, code, place, message and hint of each.
Json diagnostics_json(const Diagnostics& found);

}  // namespace kinestat
