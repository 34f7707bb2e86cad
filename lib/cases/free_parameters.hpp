// How the solutions of the cases depend on the parameters that the file leaves free.
#pragma once

#include "cases/analysis.hpp"

namespace kinestat {

/// Fills the affine dependence of every case on the parameters `{free: …}`, by solving the cases
/// again with these parameters moved. Does nothing for a file without free parameters.
void find_affine_dependence(Analysis& analysis);

}  // namespace kinestat
