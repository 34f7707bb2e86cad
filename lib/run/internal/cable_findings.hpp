// What is to be said of the ropes of a case.
#pragma once

#include "core/diagnostic.hpp"
#include "report/analysis.hpp"

namespace kinestat {

/// Warns of segments that would be pushed, with the pretension that keeps them taut, and of ropes
/// that friction does not hold.
void add_cable_findings(const Analysis& analysis, const CaseAnalysis& one, Diagnostics& found);

}  // namespace kinestat
