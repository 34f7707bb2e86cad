// Pictures of the gears of a transmission: its ratios on a logarithmic ladder (equal steps are
// equal distances) and its shift table.
#pragma once

#include "cases/analysis.hpp"
#include "draw/picture.hpp"

namespace kinestat {

/// Forward gears and, beside them, those in reverse by the size of their ratio, with the step
/// between neighbours. The analysis must have a section `shift` with a gear that has a ratio.
Picture draw_ratio_ladder(const Analysis& analysis);

/// Whether some gear has a ratio.
bool has_ratios(const Analysis& analysis);

/// Gears with their engaged elements, ratios, steps and efficiencies, then what is no gear, with
/// its class. The analysis must have a section `shift`.
Picture draw_shift_matrix(const Analysis& analysis);

}  // namespace kinestat
