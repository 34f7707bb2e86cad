// The power flow of one case as text for people.
#pragma once

#include "cases/analysis.hpp"
#include "report/in_units.hpp"
#include "report/text_blocks.hpp"

namespace kinestat {

/// What the teeth roll, which power circulates, the input, the efficiency and the balance; the
/// case must have a power flow.
TextBlocks power_blocks(const Mechanism& mechanism, const CaseAnalysis& one, const InUnits& in);

}  // namespace kinestat
