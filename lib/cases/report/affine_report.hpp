// The dependence of a case on the free parameters, as text.
#pragma once

#include <string>

#include "cases/analysis.hpp"

namespace kinestat {

/// "c.Tx [N*m] = 1.393 c_z - 3.831 h_z", a line for every magnitude that depends on a free
/// parameter; empty if none does.
std::string affine_text(const Analysis& analysis, const CaseAnalysis& one);

}  // namespace kinestat
