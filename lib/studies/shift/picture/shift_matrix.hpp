// The shift table of a transmission as a picture: which elements each gear engages.
#pragma once

#include "cases/analysis.hpp"
#include "draw/picture.hpp"

namespace kinestat {

/// Gears with their engaged elements, ratios, steps and efficiencies, then what is no gear, with
/// its class. The analysis must have a section `shift`.
Picture draw_shift_matrix(const Analysis& analysis);

}  // namespace kinestat
