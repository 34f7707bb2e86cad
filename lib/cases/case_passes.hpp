// Cases solved as far as somebody reads them.
#pragma once

#include <span>
#include <vector>

#include "cases/analysis.hpp"

namespace kinestat {

/// How much of a case is worked out.
enum class CasePasses {
  magnitudes,  ///< rates and actions alone
  row,         ///< what a row of a motion holds and is judged by: no power graph, unless the losses
               ///< of meshes need it
  all
};

/// As solve_some_cases.
std::vector<CaseAnalysis> solve_case_passes(const Mechanism& mechanism,
                                            std::span<const Case> cases,
                                            CasePasses passes);

/// One case whose motion is known already, or why it has none.
CaseAnalysis solve_case_in_motion(const Mechanism& mechanism,
                                  const Case& which,
                                  const KinematicSolution& motion,
                                  CasePasses passes);

}  // namespace kinestat
