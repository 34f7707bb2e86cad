// The mechanism in a moved position, for every other pass.
#pragma once

#include <span>
#include <vector>

#include "studies/motion/configuration.hpp"

namespace kinestat {

/// Moves the geometry, the loads and the contacts of cables of `moved`, a copy of the drawn
/// mechanism, to a configuration with these poses; names, cases and primaries stay. What a coupling
/// frees and bears follows the body in which it is fixed; forces at a point (Rx, Ry, Rz) and the
/// freedoms of a ball keep their world directions. Loads act at the moved point of their body;
/// those whose frame is that of the body turn with it.
void move_mechanism(const MotionNetwork& network,
                    std::span<const DrawnCoupling> drawn,
                    const Configuration& configuration,
                    std::span<const BodyPose> poses,
                    const Mechanism& mechanism,
                    Mechanism& moved);

}  // namespace kinestat
