// The passes of every case with as many digits as asked for, and what is proved of the ranks.
#pragma once

#include <string>

#include "cases/analysis.hpp"
#include "cases/certainty.hpp"
#include "cases/loaded.hpp"

namespace kinestat {

struct CertifiedAnalysis {
  Analysis analysis;
  Certainty certainty;
};

/// solve_cases; where the request, or what the doubles prove, asks for it, with the numbers as
/// typed.
CertifiedAnalysis solve_certified_cases(std::string file,
                                        Loaded loaded,
                                        const AccuracyRequest& request);

}  // namespace kinestat
