// The tolerances of extremes that are sought in the steps of a simulation.
#pragma once

namespace kinestat {

/// What exceeds the extremes that are known by less, as share of the largest value of its kind, is
/// not looked for: below the error of the integration.
inline constexpr double kLeastPeak = 1e-10;

/// A step in which something happens is looked at but for this share of it: what slides comes to
/// rest only up to rounding where it sticks.
inline constexpr double kBeforeEvent = 1e-9;

}  // namespace kinestat
