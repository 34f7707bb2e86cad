// How the solutions of the cases depend on the parameters that the file leaves free.
#pragma once

#include "cases/analysis.hpp"

namespace kinestat {

/// The affine dependence of every case on the parameters `{free: …}`, found when it is first asked
/// for by solving the cases again with these parameters moved.
const AffineDependence& affine_dependence(const Analysis& analysis);

/// That of one of the cases of the analysis.
const AffineCase& affine_case(const Analysis& analysis, const CaseAnalysis& one);

}  // namespace kinestat
