// Every tolerance of the program: its name, what it is relative to, and why it has this size.
#pragma once

#include <limits>

namespace kinestat {

inline constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// A difference smaller than this share of its two terms is rounding and becomes an exact zero
/// during elimination. A handful of operations precede each entry; 64 covers them.
inline constexpr double kCancellation = 64 * kEpsilon;

/// A pivot below this, in a matrix whose rows and columns are scaled to largest entry 1, counts as
/// zero. Halfway between rounding (1e-16) and the flattest geometry that is drawn on purpose
/// (1e-5).
inline constexpr double kRankZero = 1e-10;

/// A pivot is accepted if it is at least this share of the largest entry of its column: growth
/// stays below 11 a step while the sparsest row may be chosen.
inline constexpr double kPivotShare = 0.1;

/// A column whose largest entry is smaller than this waits until no better one is left, so that the
/// decision on the rank is taken last, on what really remains. Distances between neighbours in a
/// chain of 10^5 bodies stay above it, as shares of the distance from the origin: columns that wait
/// are no longer taken in the order that keeps the rows short.
inline constexpr double kPivotWaits = 1e-6;

/// Where an elimination need not go on, because another way to the answer is at hand, a pivot must
/// be at least this share of the largest entry: more than three digits are not risked. So a tape
/// gives a state back to the whole analysis.
inline constexpr double kSafePivot = 1e-3;

/// Equations that are surplus must hold to this share of the terms they sum.
inline constexpr double kConsistency = 1e-9;

/// The powers of a case must sum to zero within this share of the largest power.
inline constexpr double kPowerBalance = 1e-9;

/// The slip of a converter is sought by signs: what is smaller than this share of what it is made
/// of has none, and the position is analysed whole.
inline constexpr double kDoubtfulSign = 1e-9;

/// Where a torque jumps over what it should be, as the drag of a clutch turns its sense, it misses
/// by more than this share of what it misses at the nodes of the search.
inline constexpr double kTorqueFits = 1e-6;

/// A magnitude is affine in the free parameters if it is met at other points of them to this share
/// of its largest term. Parameters are moved by at least their own size and that of the mechanism,
/// where a function that bends shows far more.
inline constexpr double kAffine = 1e-9;

/// Two values of a condition count as equal if they differ by at most this share of the larger one:
/// some thousand roundings, and still far below what anybody types on purpose.
inline constexpr double kSameValue = 1e-12;

/// Two reports agree in a value if they differ by at most this share of the larger one: far above
/// what another compiler or order of operations changes, far below what an engineer would notice.
inline constexpr double kReportsAgree = 1e-9;

/// Two reports also agree in a value if they differ by at most this share of the largest of its
/// kind in the same case: some thousand roundings, where sums of such sizes cancel.
inline constexpr double kReportsAgreeBesideLargest = 1e-12;

/// No digits are asked for of a magnitude within its bound, if that is this share of the largest.
inline constexpr double kNoDigitsAsked = 64 * kEpsilon;

/// An angular (or force) part below this share of the other part of a screw, measured with the
/// mechanism's own length, makes the pitch infinite: a pure translation (or couple).
inline constexpr double kInfinitePitch = 1e-12;

/// Screws are written about the world origin while that is no further from the mechanism than this
/// many of its sizes; beyond, its distance would drown the geometry.
inline constexpr double kFarOrigin = 8.0;

/// The largest length or angle [SI]. Products of five of them still stay within a double.
inline constexpr double kLargestNumber = 1e60;

/// The largest velocity, force or moment, given or found [SI]. Products of two of them, and sums of
/// these, still stay within a double.
inline constexpr double kLargestMagnitude = 1e150;

/// An axis shorter than this (of components given as plain numbers) has no direction.
inline constexpr double kZeroAxis = 1e-12;

/// Friction beyond this many times what the frictionless actions cause is unbounded: it locks.
inline constexpr double kUnboundedFriction = 1e7;

/// The least share of the friction by which the solution is followed; finer steps mean that it has
/// come to an end.
inline constexpr double kLeastFrictionStep = 1e-7;

/// A reaction below this share of the whole wrench of its coupling is no load for a bearing: some
/// million roundings, far below what wears anything.
inline constexpr double kNoReaction = 1e-9;

/// Two axes are parallel if the sine of their angle is below this: far above rounding.
inline constexpr double kParallelAxes = 1e-9;

/// A cable that comes nearer to the centre of a pulley than its radius by less than this share of
/// it passes by; centres that are closer than that share are the same. Far above rounding.
inline constexpr double kGrazing = 1e-9;

/// Two places of a drawing are one if they are apart by this share of the mechanism's size: no
/// picture shows less.
inline constexpr double kDrawnTogether = 1e-5;

/// Points at which a cable is said to touch a pulley may lie inside its rim by this share of the
/// radius: drawings are rounded.
inline constexpr double kDrawnContact = 0.01;

/// A freedom that is added to release a constraint must work on a self-stress by this share of what
/// the stress could do: below it, it would hardly give way, and another position might not need it.
inline constexpr double kWorkingFreedom = 1e-4;

/// By this share the largest moment of inertia of a body may exceed the sum of the two others:
/// what is typed is rounded to some figures.
inline constexpr double kTriangleRounding = 1e-3;

/// Radii of gyration are no larger than the mechanism, and not so many times smaller, unless a unit
/// is wrong.
inline constexpr double kLeastGyration = 1e-3;

/// By this share of the places the end of a motion that a file gives may differ from the one that
/// follows from its time: both are typed.
inline constexpr double kSameEnd = 1e-6;

/// The sine of the angle by which a body may turn about another axis than that of its inertia.
inline constexpr double kRotorAxis = 1e-9;

/// Forces of inertia that may be off by more than this share of the largest get a word.
inline constexpr double kKnownInertia = 1e-3;

/// A body that turns by itself has no inertia about that axis if it is this share of what it could
/// have at most: that of a slender rod is as exact as its coordinates are typed.
inline constexpr double kIdleInertia = 1e-9;

/// The points of a spring that are nearer than this share of the mechanism's size meet.
inline constexpr double kNoSpringLength = 1e-12;

/// By this share of its stroke a gas spring may be past its ends: what is typed is rounded.
inline constexpr double kPastStroke = 1e-9;

/// A place beyond the end of a curve by no more than this share of its length is at its end, and
/// one as near to a period behind its beginning is there.
inline constexpr double kCurveEnd = 1e-9;

}  // namespace kinestat
