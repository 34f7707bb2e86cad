// Why rows of a finite motion have no velocities or accelerations.
#pragma once

#include "run/motion.hpp"

namespace kinestat {

/// What analysis says of the known motions at the first of these positions, or what is singular
/// there; nothing where all rows have what was asked for.
void add_motion_speed_findings(const FoundMotion& motion,
                               const MechanismDescription& description,
                               const Mechanism& mechanism,
                               Diagnostics& found);

}  // namespace kinestat
