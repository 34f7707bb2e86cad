// Runs the passes that each case asks for, and nothing else.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "cases/analysis.hpp"
#include "cases/certainty.hpp"
#include "core/accuracy.hpp"

namespace kinestat {

/// A case that names motions has its velocities solved, one that names actions or on which loads
/// act its statics; power and ratios where both sides, or an input and an output, are there. The
/// motions are always counted, the actions if some case asks for any or if there are no cases.
Analysis solve_cases(std::string file, Loaded loaded, const AccuracyRequest& request = {});

/// These cases alone, which may be others than those of the mechanism.
std::vector<CaseAnalysis> solve_some_cases(const Mechanism& mechanism,
                                           std::span<const Case> cases,
                                           const AccuracyRequest& request = {});

/// One case as an analysis answers it: with bounds, and with the numbers as typed where the bounds
/// ask for them. `mechanism` must be what bind made of the description, and `which` its case of
/// that index, perhaps with fewer passes.
CaseAnalysis solve_certified_case(const MechanismDescription& description,
                                  const Mechanism& mechanism,
                                  std::size_t index,
                                  const Case& which);

/// The passes of every case with as many digits as asked for, and what is proved of the ranks.
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
