// The tolerances of synthesis, as in core/tolerance.hpp.
#pragma once

namespace kinestat {

/// Two conics share a line if the matrix of their multiples loses rank by this share: roots that
/// are merely double leave it at about 1e-2, data rounded to double at 1e-15.
inline constexpr double kSharedComponent = 1e-10;

/// A point that two conics share is real if no homogeneous coordinate, the largest being 1, has an
/// imaginary part above this.
inline constexpr double kRealPoint = 1e-7;

/// Two such points closer than this are one double point: rounding splits it by the root of 1e-16,
/// and a hundred times that leaves room for data that are rounded too.
inline constexpr double kDoublePoint = 1e-6;

/// Points found before they are improved must lie on both conics to this share; else the roots are
/// sought along another line.
inline constexpr double kRoughPoint = 1e-6;

/// A crank longer than this many sizes of the task may be a slider whose positions are rounded:
/// over the task its arc leaves a straight line by an eighth of the reciprocal.
inline constexpr double kLongCrank = 1e3;

/// A circle of a task may be at most this many times as large as the spread of its positions for
/// the scale of the equations.
inline constexpr double kLongestLever = 1e6;

/// Angles of positions that differ by less than this are the same: far above rounding.
inline constexpr double kSameAngle = 1e-13;

/// E, its centre and the pole count as collinear if the sine of the angle between them is below
/// this: coordinates typed with nine figures pass.
inline constexpr double kCollinearSpecification = 1e-7;

/// Two choices of a selection give the same linkage if its ratio of links and longest link agree to
/// this share: the search has come much nearer to the best place by then.
inline constexpr double kSameLinkage = 1e-5;

/// Four links are at a change point if shortest and longest equal the other two to this share of
/// their sum, or within the bounds of their lengths.
inline constexpr double kChangePoint = 1e-10;

/// Ratios of gears may leave the closed ranges that are asked for by this share: rounding leaves
/// 1e-14, and teeth are a thousand times as coarse.
inline constexpr double kRangeSlack = 1e-9;

/// Teeth that are off a stationary ratio by no more have it nearly: those of a search over ranges
/// are thousandths.
inline constexpr double kNearStationaryRatio = 1e-3;

/// Ranks of transmissions that differ by less are the same: rounding leaves 1e-15.
inline constexpr double kSameRank = 1e-9;

/// An output that turns slower than this share of the input's speed rests: the state is no gear.
inline constexpr double kRestingOutput = 1e-9;

/// What a mechanism in teeth and the search may differ by: ratios, which are quotients of a few
/// products, and torques and efficiencies, behind which whole equations are solved.
inline constexpr double kVerifiedRatio = 1e-12;
inline constexpr double kVerifiedTorque = 1e-9;

/// Dyads of positions that lose all but one digit are not worth having.
inline constexpr double kUselessLoss = 0.1;

/// A condition in which rounding of the positions has more than this share stems from positions
/// that are too close to each other, not from ones that depend on each other.
inline constexpr double kNoisyRow = 1e-12;

/// Conditions that depend on each other leave singular values above this share, and then rounding;
/// positions that close in leave them on all decades.
inline constexpr double kClearGap = 1e-7;

}  // namespace kinestat
