// Solves cases: runs the passes that each of them asks for, and no others.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "cases/analysis.hpp"
#include "cases/certainty.hpp"
#include "core/accuracy.hpp"

namespace kinestat {

/// Solves all cases of a file. A case that names motions is solved for velocities; a case that
/// names actions, or on which loads act, for actions. Powers are found if it has both, ratios if it
/// names an input and an output. Motions are always counted; actions are counted if some case asks
/// for them, or if there are no cases.
Analysis solve_cases(std::string file, Loaded loaded, const AccuracyRequest& request = {});

/// Solves only these cases, which need not be those of the mechanism.
std::vector<CaseAnalysis> solve_some_cases(const Mechanism& mechanism,
                                           std::span<const Case> cases,
                                           const AccuracyRequest& request = {});

/// Solves one case as an analysis does: with error bounds, and with the numbers as typed if the
/// bounds require it. `mechanism` must be what bind made of the description, and `which` its case
/// of that index, perhaps with fewer passes.
CaseAnalysis solve_certified_case(const MechanismDescription& description,
                                  const Mechanism& mechanism,
                                  std::size_t index,
                                  const Case& which);

/// An analysis whose answers have the requested digits, and what is proved about its ranks.
struct CertifiedAnalysis {
  Analysis analysis;
  Certainty certainty;
};

/// Does what solve_cases does, and uses the numbers as typed if the request, or what the doubles
/// prove, requires it.
CertifiedAnalysis solve_certified_cases(std::string file,
                                        Loaded loaded,
                                        const AccuracyRequest& request);

}  // namespace kinestat
