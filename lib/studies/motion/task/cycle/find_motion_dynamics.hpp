// The section `dynamics` answered.
#pragma once

#include <optional>

#include "core/diagnostic.hpp"
#include "studies/motion/report/motion_dynamics.hpp"
#include "studies/motion/task/found_motion.hpp"

namespace kinestat {

/// What the section asks of a motion; empty without one. Of what the motion does not tell E0514
/// says why.
std::optional<MotionDynamics> find_motion_dynamics(const MechanismDescription& description,
                                                   const Mechanism& mechanism,
                                                   const FoundMotion& motion,
                                                   Diagnostics& found);

}  // namespace kinestat
