// The motion of a mechanism with a hundred digits, by its couplings alone: no tree, closure or
// derivative of the library is in it.
#pragma once

#include <span>
#include <vector>

#include "couplings/finite_law.hpp"
#include "math/numbers/big_float.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// [ω; v] about the origin.
using PreciseTwist = std::array<BigFloat, 6>;

struct PreciseMotion {
  std::vector<BigFloat> positions;   ///< of the freedoms [rad or m]
  std::vector<BigFloat> rates;       ///< likewise
  std::vector<BigFloat> rate_rates;  ///< likewise
  std::vector<PreciseTwist> twists;  ///< of the bodies
  std::vector<PreciseTwist> twist_rates;
  double miss = 1.0;  ///< what its circuits miss
};

struct PreciseDrive {
  int freedom = 0;
  double position = 0.0;
  double speed = 0.0;
  double acceleration = 0.0;
};

/// All couplings are chains of turns and slides. Newton's method begins at `near`, of all freedoms.
/// Directions are taken as unit vectors.
PreciseMotion precise_motion(const Mechanism& mechanism,
                             std::span<const FiniteLaw> laws,
                             std::span<const PreciseDrive> drives,
                             std::span<const double> near);

}  // namespace kinestat
