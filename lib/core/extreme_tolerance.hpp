// The tolerances of what is sought between the rows of motions and in the steps of simulations.
#pragma once

namespace kinestat {

/// What exceeds the extremes that are known by less, as share of the largest value of its kind, is
/// not looked for: below the error of the integration.
inline constexpr double kLeastPeak = 1e-10;

/// A step in which something happens is looked at but for this share of it: what slides comes to
/// rest only up to rounding where it sticks.
inline constexpr double kBeforeEvent = 1e-9;

/// What dips below zero and rises again, by no more than this share of its largest value in the
/// step, only touches it.
inline constexpr double kDeepestGraze = 1e-11;

/// Means of the squares of what laws of drives do, by points of Gauss, agree to this share of
/// themselves: a mean within it of its root mean square may be zero.
inline constexpr double kMeansAgree = 0x1p-17;

}  // namespace kinestat
