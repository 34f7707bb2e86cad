// What all bodies and couplings have in each case, for bar maps.
#pragma once

#include "cases/analysis.hpp"
#include "draw/bar_map.hpp"

namespace kinestat {

/// Angular velocities of the bodies and velocities of their reference points, by components in the
/// world frame, in the units of the file. Components that are zero throughout are named below.
BarMap speed_map(const Analysis& analysis);

/// Moments that the couplings bear about their own points (Cazangi 2008, figures 5.13a to 5.25a);
/// `torque` and `force` hold the actions of tail on head.
BarMap torque_map(const Analysis& analysis);

/// Forces that the couplings bear (figures 5.13b and c to 5.25b and c).
BarMap force_map(const Analysis& analysis);

}  // namespace kinestat
