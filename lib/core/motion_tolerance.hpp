// The tolerances of finite motion: what each is relative to, and why it has this size.
#pragma once

namespace kinestat {

/// A moved position is closed if nothing misses by more than this share of the size: some
/// hundred roundings.
inline constexpr double kMotionClosure = 3e-14;

/// An overconstrained mechanism that is not drawn exactly closes by least squares; this share of
/// its size may be left: points that were typed with six figures.
inline constexpr double kAcceptedClosureError = 1e-5;

/// Its drives can move it if what their rates miss of closure is less than this share: directions
/// follow from differences of points that were rounded.
inline constexpr double kAcceptedRateMiss = 1e-5;

/// A drawn position that misses by less than this share of the size is closed without a word:
/// decimals that were rounded.
inline constexpr double kSilentCorrection = 1e-9;

/// A correction of a joint below this, in radians or shares of the size, is rounding.
inline constexpr double kLeastCorrection = 1e-12;

/// An action of a moved position is determined if a self-stress moves it by less than this many
/// closure_errors of the position, as share of the stress: levers near dead points take two digits.
inline constexpr double kClosureInActions = 100.0;

/// Teeth roll in a carrier if their relative motion is that of two lines in it to this share:
/// pitch points that were typed with seven figures pass.
inline constexpr double kSlackInCarrier = 1e-6;

/// Where the shortest column of a closure is this share of the longest, a singular position is
/// near: from here on the arc is followed instead of the drives.
inline constexpr double kFlatClosure = 1e-4;

/// Where the shortest column of a closure is below this share of the longest, velocities, whose
/// error is that of closure by this share, are left out.
inline constexpr double kFlatVelocity = 1e-8;

/// A position lies off its branch by what it misses over that share, and its velocities are wrong
/// by as much again over it: above this share they are left out.
inline constexpr double kMostVelocityError = 1e-3;

/// Below this the accelerations, whose error is that of closure by its square, are left out.
inline constexpr double kFlatAcceleration = 1e-5;

/// The finest part of a step of a motion by its drives; then the arc is followed.
inline constexpr double kFinestShare = 1e-3;

/// The finest step of the arc, in radians or shares of the size; then the branch is lost.
inline constexpr double kFinestArc = 1e-11;

/// A limit that is this near to the end asked for, as share of the range, is that end: what reports
/// write of a limit has more digits.
inline constexpr double kAskedLimit = 1e-9;

/// A position is reached if the drives are this near, as share of their range.
inline constexpr double kArrivedShare = 1e-7;

/// How narrow a change point is bracketed, along the arc.
inline constexpr double kChangePointBracket = 1e-9;

/// Where the determinant touches zero, the points on both sides are brought as near to each other
/// [rad or shares of the size, of the drives]: there a cubic leaves less than rounding.
inline constexpr double kTouchSurroundings = 1e-4;

/// Between its surroundings a change point misses closure by no more than this: what cubics leave,
/// and rounding. Branches that miss each other by more do not cross.
inline constexpr double kGapAtCrossing = 3e-13;

/// Between two looks so near each other a rate does not turn back twice [rad, or shares of the
/// size, of the fastest freedom].
inline constexpr double kLeastLook = 1e-6;

/// Steps that differ by less than this share are equal.
inline constexpr double kSameStep = 1e-9;

/// How near motions are looked at before and behind a place where values jump, as share of a step;
/// steps that are no farther apart than twice that belong to one place.
inline constexpr double kApproach = 0x1p-20;
inline constexpr double kSameApproach = 2.5 * kApproach;

/// By so much of its largest value a column differs there, or does not jump.
inline constexpr double kJump = 1e-4;

/// Drives that part by less from a straight line run along it [rad, or shares of the size]: what
/// happens on it happens on their way.
inline constexpr double kStraightWay = 1e-13;

/// A cable that lies on its pulley by this much less than nothing [rad] runs straight past it: the
/// angles of its segments are rounded.
inline constexpr double kStraightArc = 1e-12;

/// Between the positions of a motion, rates below this share of the fastest get the bound of their
/// error, which says whether they are zero.
inline constexpr double kDoubtfulRate = 1e-6;

/// How narrow a dead point is bracketed, by the fastest drive [rad or shares of the size].
inline constexpr double kDeadPointBracket = 1e-11;

/// What may be missed where a freedom was tried: ten times that of a motion.
inline constexpr double kTrialClosure = 1e-12;

/// A trial that is off its direction by less than this share of its step goes straight.
inline constexpr double kStraightEnough = 1e-6;

/// Values along a cycle are polynomials between places; the last of their terms are at most this
/// share of the largest value: what is derived from them is asked for to 1e-9.
inline constexpr double kCycleTail = 1e-12;

/// Below this share they are rounding, where halves of a piece have them as large.
inline constexpr double kCycleNoise = 1e-9;

/// The finest piece, as share of the whole cycle: what jumps in it counts for no more than that.
inline constexpr double kFinestCyclePiece = 1e-10;

/// A harmonic below this share of what was taken apart is what polynomials leave.
inline constexpr double kNoHarmonic = 1e-10;

/// At the end of a cycle everything is where it was at its begin, and acts as then, to this share:
/// far above rounding, far below what any other position would show.
inline constexpr double kCycleReturns = 1e-8;

/// By this share a rate may differ from steady along a cycle, and what was foretold of another
/// speed from what is found at it.
inline constexpr double kSteady = 1e-8;

}  // namespace kinestat
