// Numbers of few decimal figures.
#pragma once

namespace kinestat {

/// The double next to the number when that is rounded to so many decimal figures, 1 to 15. As it is
/// where it is zero, not finite, below 1e-8 or so large that the power of ten is no double.
double round_to_figures(double number, int figures);

}  // namespace kinestat
