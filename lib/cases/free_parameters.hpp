// The dependence of the cases on the parameters that the file leaves free.
#pragma once

#include "cases/analysis.hpp"

namespace kinestat {

/// The affine dependence of every case on the parameters `{free: …}`. It is found when it is first
/// requested, by solving the cases again with these parameters changed.
const AffineDependence& affine_dependence(const Analysis& analysis);

/// The affine dependence of one of the cases of the analysis.
const AffineCase& affine_case(const Analysis& analysis, const CaseAnalysis& one);

}  // namespace kinestat
