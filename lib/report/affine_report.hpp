// The dependence of a case on the free parameters, as text and JSON.
#pragma once

#include <string>

#include "report/analysis.hpp"
#include "report/json_values.hpp"

namespace kinestat {

/// "c.Tx [N*m] = 1.393 c_z - 3.831 h_z", a line for every magnitude that depends on a free
/// parameter; empty if none does.
std::string affine_text(const Analysis& analysis, const CaseAnalysis& one);

/// By magnitude the constant under "1" and the coefficients under the names of the parameters, in
/// the units of the file; null for a magnitude that is not affine in them. A parameter without
/// influence is left out.
Json affine_json(const Analysis& analysis, const CaseAnalysis& one);

}  // namespace kinestat
