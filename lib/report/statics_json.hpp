// The statics of one case as JSON.
#pragma once

#include "report/analysis.hpp"
#include "report/in_units.hpp"
#include "report/json_values.hpp"

namespace kinestat {

/// Status, magnitudes, wrenches, loads and evidence; what equilibrium does not determine is null.
/// The case must have an action solution.
Json statics_json(const Mechanism& mechanism, const CaseAnalysis& one, const InUnits& in);

}  // namespace kinestat
