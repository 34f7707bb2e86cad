// Freedoms that no other body feels: a rod that spins between two ball joints.
#pragma once

#include <vector>

#include "mechanism/mechanism.hpp"
#include "screw/coordinate_basis.hpp"

namespace kinestat {

/// Some bodies that turn or shift as one while all others rest: only the couplings between the two
/// move, and these join it to two bodies at least. So neither of them feels it.
struct PassiveFreedom {
  std::vector<BodyId> bodies;  ///< those that move
  Twist twist;                 ///< of all of them [SI]
  VecX rates;                  ///< one a freedom of the mechanism [SI]
};

/// Those of single bodies and of short chains of bodies with two couplings each, which do not
/// follow from each other. What an actuator moves is felt, and so is a coupling of one freedom that
/// a case drives or holds.
std::vector<PassiveFreedom> find_passive_freedoms(const Mechanism& mechanism,
                                                  const CoordinateBasis& basis);

}  // namespace kinestat
