// Cases solved with some passes only, as far as a caller needs them.
#pragma once

#include <vector>

#include "cases/analysis.hpp"

namespace kinestat {

/// Solves all cases for their rates and actions alone.
std::vector<CaseAnalysis> solve_magnitudes(const Mechanism& mechanism);

/// What is known of a position in addition to the case.
struct KnownState {
  const KinematicSolution* motion = nullptr;  ///< its motion, whose status may be any
  const InertialMotion* inertial = nullptr;   ///< of a case with inertia
  const LoadState* place = nullptr;           ///< where it stands; null: as drawn
};

/// Solves a case for a row of a motion: what the row contains and what it is judged by. The power
/// graph is left out unless the losses of meshes need it.
CaseAnalysis solve_row(const Mechanism& mechanism, const Case& which, const KnownState& known);

}  // namespace kinestat
