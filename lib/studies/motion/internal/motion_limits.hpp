// How far a step of a motion may go. What counts as closed is in core/motion_tolerance.hpp.
#pragma once

#include <limits>

#include "core/motion_tolerance.hpp"
#include "core/tolerance.hpp"

namespace kinestat {

/// Closures are in sizes of the mechanism: columns are short or not compared with it too.
inline constexpr double kSize = 1.0;

/// The largest correction that Newton begins with [rad or shares of the size].
inline constexpr double kFarCorrection = 1.0;

/// The corrector may move a joint by this share of the step: more would be another branch.
inline constexpr double kMostCorrection = 0.1;
inline constexpr double kMostArcCorrection = 0.2;

/// Rates may change by this share of the largest in one step; tangents of the arc by this cosine.
inline constexpr double kMostTangentChange = 0.4;
inline constexpr double kLeastTangentCosine = 0.97;

/// Steps in radians or shares of the size: of the drives, on the way to where they begin, and of
/// the arc.
inline constexpr double kLongestStep = 0.35;
inline constexpr double kStepToStart = 0.1;
inline constexpr double kFirstArc = 0.01;
inline constexpr double kLongestArc = 0.1;

/// Where the shortest column of a closure is so short a share of the longest, two singular
/// positions may lie in a long step: then it is no longer than this.
inline constexpr double kNearSingularity = 0.1;
inline constexpr double kNearSingularStep = 0.1;

/// Drives that run by laws of their own are followed along straight lines from which they part by
/// no more [rad, or sizes of the mechanism].
inline constexpr double kMostBow = 0.02;

/// Cables whose arcs are shorter than a step are looked at in shorter ones, down to this.
inline constexpr double kLeastCableStep = 0.01;

/// So far of the drives the arc is followed past what stood in the way of a step of theirs.
inline constexpr double kArcStretch = 0.5;

/// How far from a singular drawn position it is looked whether the rank comes back.
inline constexpr double kNearby = 0.01;

/// All turns in a step together, so that full turns can be counted [rad].
inline constexpr double kMostTurnInStep = 3.0;

/// Coordinates of many turns are rounded: so many of their roundings may be missed.
inline constexpr double kTurnRoundings = 8.0;

/// A bound of a rate below this share of all rates of the joints together is rounding of the sums
/// that it is made of, which lose a third of their digits at most; above, a singular position is
/// near and enlarges it. Likewise of derivatives, beside all of these and the squares of rates.
inline constexpr double kRoundingOfRates = 0x1p18 * kEpsilon;

/// How far a freedom is tried at first.
inline constexpr double kTrialStep = 0.01;

/// Where conditions depend on each other it is followed so far: what misses with a high power of
/// the way misses by rounding at first.
inline constexpr double kFarTrial = 0.5;

/// The longest and the shortest of the steps that it is followed by.
inline constexpr double kLongestTrialStep = 0.05;
inline constexpr double kLeastTrialStep = 0x1p-13;

/// By this share of such a step the closed point may be off its direction.
inline constexpr double kMostTrialTurn = 0.5;

/// A closed point less than this share of the step away is where the step began.
inline constexpr double kLeastTrialWay = 0.5;

/// The part of a direction that stays open must be so long a share of it to lead on.
inline constexpr double kLeadsOn = 0.5;

/// Half the step must leave this share of the deviation at most if that shrinks with its square.
inline constexpr double kShrinks = 0.75;

/// A trial whose way by half the step is so many times as long a share of it has closed somewhere
/// else, whatever the step.
inline constexpr double kGrowingShare = 1.3;

/// How far apart the regular points are from which a change point between them follows: a cubic
/// leaves some roundings.
inline constexpr double kSurroundings = 0.001;

/// At a change point the determinant is this share at most of what it is beside it.
inline constexpr double kLeftAtCrossing = 0.01;

/// In a step at whose ends the reciprocal condition number is together so many times what it may
/// fall and rise again on the way, it may come down to zero between them: it does not fall evenly.
inline constexpr double kMostTouch = 1.5;

/// Where no step lies before: the reciprocal condition number may fall as fast as it likes.
inline constexpr double kUnknownFall = std::numeric_limits<double>::infinity();

/// Such a place is looked at in parts, each so many times as short as the one before.
inline constexpr double kNarrows = 0.1;

inline constexpr int kMostRounds = 8;
inline constexpr int kMostBisections = 100;
inline constexpr int kMostArcs = 100'000;

/// The nearest position, by Levenberg and Marquardt.
inline constexpr int kMostNearestRounds = 500;
inline constexpr double kFirstDamping = 0.001;
inline constexpr double kMostDamping = 1e12;

}  // namespace kinestat
