// The power flow of one case as JSON.
#pragma once

#include "report/analysis.hpp"
#include "report/in_units.hpp"
#include "report/json_values.hpp"

namespace kinestat {

/// cases/<label>/power; the case must have a power flow.
Json power_json(const Mechanism& mechanism, const CaseAnalysis& one, const InUnits& in);

}  // namespace kinestat
