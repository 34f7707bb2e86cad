// What the members of planets say of their planets.
#pragma once

#include "mechanism/check/section_context.hpp"
#include "mechanism/gears/gear_layout.hpp"

namespace kinestat {

/// Complains of planets without a distance from the main axis or with two, of meshes of two planets
/// without a module, and of `count`, `centre_distance` and `side` where they mean nothing. After it
/// a layout can be found.
void check_planet_members(const SectionContext& context,
                          const GearTrain& train,
                          const GearNumbers& numbers);

}  // namespace kinestat
