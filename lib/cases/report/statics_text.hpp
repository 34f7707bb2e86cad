// The actions and powers of one case as tables for people.
#pragma once

#include "cases/analysis.hpp"
#include "report/in_units.hpp"
#include "report/text_blocks.hpp"

namespace kinestat {

/// Actuators, the wrench of every coupling, the loads, and the power balance; where equilibrium
/// leaves actions open, every action by itself instead. The case must have an action solution.
TextBlocks statics_blocks(const Mechanism& mechanism, const CaseAnalysis& one, const InUnits& in);

}  // namespace kinestat
