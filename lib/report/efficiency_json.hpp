// The efficiencies of a case with lossy meshes as JSON.
#pragma once

#include "report/analysis.hpp"
#include "report/in_units.hpp"
#include "report/json_values.hpp"

namespace kinestat {

/// Adds `efficiency` by both models, with the reason where there is none, and `losses`: what is
/// lost where and what acts then in the carrier model, if it has an answer. The case must have
/// efficiencies.
void add_efficiency(const Mechanism& mechanism,
                    const CaseAnalysis& one,
                    const InUnits& in,
                    Json& power);

}  // namespace kinestat
