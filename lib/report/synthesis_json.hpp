// The answers to a synthesis task as JSON, by schemas/synthesis.schema.json.
#pragma once

#include "report/json_values.hpp"
#include "report/synthesis_report.hpp"

namespace kinestat {

/// The key "synthesis". Lengths and angles in the units of the file; derivatives of a position are
/// by its parameter, in radians where that is the angle.
Json synthesis_json(const SynthesisAnalysis& analysis);

}  // namespace kinestat
