// Numbers of few decimal figures.
#pragma once

namespace kinestat {

/// The double next to the number when that is rounded to so many decimal figures, 1 to 15. As it is
/// where it is zero, not finite, from 1e21 or so small that the power of ten is no double: below
/// 1e-8 for 15 figures.
double round_to_figures(double number, int figures);

}  // namespace kinestat
