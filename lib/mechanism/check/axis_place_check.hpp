// Places of couplings that are a single number along the axis of a gear.
#pragma once

#include "mechanism/gears/internal/gear_binder.hpp"

namespace kinestat {

/// Whether a coupling may stand where it does. Complains of a single number in a file without
/// `gears`, in the plane, where an axis is a point, and of a coupling between two planets. `gears`
/// is null if there are none or if they are wrong.
bool check_axis_place(const CouplingDescription& coupling,
                      const MechanismDescription& description,
                      const GearFrame* gears,
                      Diagnostics& found);

}  // namespace kinestat
