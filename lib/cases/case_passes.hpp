// Cases solved as far as somebody reads them.
#pragma once

#include <vector>

#include "cases/analysis.hpp"

namespace kinestat {

/// Of all cases the rates and actions alone.
std::vector<CaseAnalysis> solve_magnitudes(const Mechanism& mechanism);

/// What is known of a position beside the case.
struct KnownState {
  const KinematicSolution* motion = nullptr;  ///< its motion, or why it has none
  const InertialMotion* inertial = nullptr;   ///< of a case with inertia
  const LoadState* place = nullptr;           ///< where it stands; null: as drawn
};

/// What a row of a motion holds and is judged by: no power graph, unless the losses of meshes need
/// it.
CaseAnalysis solve_row(const Mechanism& mechanism, const Case& which, const KnownState& known);

}  // namespace kinestat
