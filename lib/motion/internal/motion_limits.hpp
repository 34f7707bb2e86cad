// How closely a motion is followed, and how far a step may go.
#pragma once

#include "core/tolerance.hpp"

namespace kinestat {

/// A position is closed if nothing misses by more than this share of the size: some hundred
/// roundings.
inline constexpr double kMotionClosure = 1e-13;

/// An overconstrained mechanism that is not drawn exactly closes by least squares; this much may
/// be left.
inline constexpr double kAcceptedMisclosure = 1e-6;

/// A drawn position that misses by less is closed without a word: decimals that were rounded.
inline constexpr double kSilentCorrection = 1e-9;

/// A correction of the joints below this is rounding.
inline constexpr double kLeastCorrection = 1e-12;

/// Teeth roll in a carrier if their relative motion is that of two lines in it to this share:
/// pitch points that were typed with seven figures pass.
inline constexpr double kSlackInCarrier = 1e-6;

/// A closure whose shortest column is this share of the longest is near a singular position: from
/// here on the arc is followed instead of the drives.
inline constexpr double kFlatClosure = 1e-4;

/// The finest parts of a step by the drives, and of the arc.
inline constexpr double kFinestShare = 1e-3;
inline constexpr double kFinestArc = 1e-11;

/// A position is reached if the drives are this near, as share of their range.
inline constexpr double kArrivedShare = 1e-7;

/// How narrow a change point is bracketed, along the arc.
inline constexpr double kChangePointBracket = 1e-9;

/// The largest correction that Newton begins with.
inline constexpr double kFarCorrection = 1.0;

/// The corrector may move a joint by this share of the step: more would be another branch.
inline constexpr double kMostCorrection = 0.1;
inline constexpr double kMostArcCorrection = 0.2;

/// Rates may change by this share of the largest in one step.
inline constexpr double kMostTangentChange = 0.4;
inline constexpr double kLeastTangentCosine = 0.97;

/// Steps in radians or sizes of the mechanism.
inline constexpr double kLongestStep = 0.35;
inline constexpr double kStepToStart = 0.1;
inline constexpr double kNearby = 0.01;
inline constexpr double kFirstArc = 0.01;
inline constexpr double kLongestArc = 0.1;

/// All turns in a step together, so that full turns can be counted [rad].
inline constexpr double kMostTurnInStep = 3.0;

/// How far a freedom is tried, and how much may be missed there.
inline constexpr double kTrialStep = 0.01;
inline constexpr double kTrialClosure = 1e-12;

/// Half the step must leave this share of the deviation at most; a smaller deviation than the
/// second is none.
inline constexpr double kShrinks = 0.75;
inline constexpr double kStraightEnough = 1e-6;

/// A trial that comes back to less than this share of its step has not moved.
inline constexpr double kLeastWay = 0.1;

/// How far apart the regular points are from which a change point between them follows: a cubic
/// leaves some roundings.
inline constexpr double kSurroundings = 0.001;

inline constexpr int kMostRounds = 8;
inline constexpr int kMostBisections = 100;
inline constexpr int kMostArcs = 100'000;
inline constexpr int kMostNearestRounds = 500;
inline constexpr double kFirstDamping = 1e-3;
inline constexpr double kMostDamping = 1e12;

}  // namespace kinestat
