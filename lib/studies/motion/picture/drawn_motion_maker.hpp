// A motion that was found, as drawings of the mechanism show it.
#pragma once

#include <cstddef>
#include <vector>

#include "draw/linkage/drawn_motion.hpp"
#include "studies/motion/task/found_motion.hpp"

namespace kinestat {

/// Where the bodies are in a configuration; `mechanism` is as drawn, and `moved` becomes what
/// stands there.
LinkagePosition drawn_position(const MotionNetwork& network,
                               const std::vector<DrawnCoupling>& drawn,
                               const Configuration& configuration,
                               const Mechanism& mechanism,
                               Mechanism& moved);

/// Where the bodies are in the positions `shown` of a solution, which may have other steps than
/// that of the motion; and the traced points in every position. `mechanism` is as drawn.
DrawnMotion make_drawn_motion(const FoundMotion& motion,
                              const MotionSolution& solution,
                              const std::vector<std::size_t>& shown,
                              const Mechanism& mechanism);

}  // namespace kinestat
