// How many actuators keep every cable in tension.
#pragma once

#include <optional>
#include <vector>

#include "mechanism/mechanism.hpp"

namespace kinestat {

/// The action of an actuator that takes part in a pretension.
struct TensioningDrive {
  int freedom = 0;         ///< that it drives
  bool is_couple = false;  ///< [N·m], otherwise [N]
  double action = 0.0;     ///< of tail on head [N·m or N]
};

/// Cables only pull, so that a mechanism that moves as it should may still go slack. As many
/// actuators as there are freedoms determine all motions (Alves 2023, section 3.3.1, p. 61), but,
/// holding no more than the mechanism lets them, they cannot pretension it: that takes actuators
/// that work against each other, the "redundancy of actuation" at the end of section 3.3.2, one
/// more than the freedoms for a machine like a cable robot (m = n + 1). Where a self-stress of the
/// cables alone pulls on all segments, as in a belt, nothing is needed.
struct CableTension {
  int segments = 0;          ///< couplings of type cable
  int net_freedom = 0;       ///< F_N: so many actuators determine all motions
  int without_slip = 0;      ///< F_N if no cable slipped on its pulley
  bool is_possible = false;  ///< some pretension without loads pulls on every segment
  /// For a tension of at least 1 N in each segment; none if the cables keep themselves in tension.
  /// Few of them, then small actions. Virtual links have no drives.
  std::vector<TensioningDrive> drives;
  /// Determine all motions with the drives among them: F_N, and one more for each dependence of
  /// the drives.
  int actuators = 0;

  /// No smaller number does. With several dependences another choice of drives might.
  bool is_least() const { return actuators <= net_freedom + 1; }
};

/// Empty without cables.
std::optional<CableTension> find_cable_tension(const Mechanism& mechanism);

}  // namespace kinestat
