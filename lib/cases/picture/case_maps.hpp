// Bar maps of the speeds of bodies and the actions of couplings in each case.
#pragma once

#include "cases/analysis.hpp"
#include "draw/bar_map.hpp"

namespace kinestat {

/// The angular velocities of the bodies and the velocities of their reference points, by components
/// in the world frame, in the units of the file. A remark names components that are zero
/// throughout.
BarMap speed_map(const Analysis& analysis);

/// The moments that the couplings bear, of tail on head, about their own points (Cazangi 2008,
/// figures 5.13a to 5.25a).
BarMap torque_map(const Analysis& analysis);

/// The forces that the couplings bear, of tail on head (figures 5.13b and c to 5.25b and c).
BarMap force_map(const Analysis& analysis);

}  // namespace kinestat
