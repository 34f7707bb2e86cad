// The efficiency of a solved case with all that it loses.
#pragma once

#include "cases/analysis.hpp"

namespace kinestat {

/// With losses of meshes that of the model that the file prefers, else that of friction alone.
/// Without value or reason where nothing loses power, or the case does not name both ends.
Efficiency case_efficiency(const CaseAnalysis& one, const Mechanism& mechanism);

/// Whether anything that loses power acts in the case.
bool loses_power(const CaseAnalysis& one);

/// Whether the case names inputs and outputs, and loses power, and still has no efficiency.
bool lacks_efficiency(const CaseAnalysis& one, const Mechanism& mechanism);

}  // namespace kinestat
