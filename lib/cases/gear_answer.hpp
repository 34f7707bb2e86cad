// The answer of a case that is a gear, as the shift table sees it.
#pragma once

#include "cases/analysis.hpp"
#include "studies/shift/solved_gear.hpp"

namespace kinestat {

/// The view of a gear that the shift table uses; it refers to all arguments, which must outlive it.
SolvedGear solved_gear(const Mechanism& mechanism,
                       const ShiftPlan& plan,
                       const ShiftState& state,
                       const CaseAnalysis& one);

}  // namespace kinestat
