// Whether a gear train can stand and be assembled as its teeth say.
#pragma once

#include "mechanism/check/section_context.hpp"

namespace kinestat {

/// Complains of meshes between gears on one axis and of planets without a distance from the main
/// axis. Warns of distances that differ and of bearings beside their axis (W0305), of planets that
/// cannot be spaced equally (W0306) and of planets that touch (W0307): all three may be meant, by
/// teeth with profile shift or planets at unequal angles. The numbers of `gears` must be right, its
/// meshes couplings.
void check_gear_train(const SectionContext& context);

}  // namespace kinestat
