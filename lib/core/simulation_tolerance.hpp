// The tolerances of simulations: what each is relative to, and why it has this size.
#pragma once

namespace kinestat {

/// What a step of the integration may be off, where the file does not say it, and the bounds of
/// what it may say: rounding, and more than a drawing shows.
inline constexpr double kUsualIntegration = 1e-9;
inline constexpr double kFinestIntegration = 1e-13;
inline constexpr double kCoarsestIntegration = 1e-3;

/// Slip of a clutch that is this share of the fastest is what the integration may be off.
inline constexpr double kLeastSlip = 1e-6;

/// A joint whose motion is this share of the largest is told from those that stand still with the
/// others.
inline constexpr double kIndependentJoint = 1e-6;

/// Positions of a freedom by two trees of a mechanism are the same to this [rad, or sizes].
inline constexpr double kSamePosition = 1e-7;

/// Rows so near each other, as share of what is between two, are one.
inline constexpr double kSameRow = 1e-6;

/// Energy that nothing explains, as share of what is exchanged, is an error from this on.
inline constexpr double kEnergyMissed = 1e-3;

/// A rotor turns about its axis to this share: as typed.
inline constexpr double kOffRotorAxis = 1e-6;

/// A freedom that begins so near a stop touches it [rad, or sizes of the mechanism].
inline constexpr double kAtStop = 1e-12;

/// Sliding that is this share of the fastest comes to an end, and where it is no more than the
/// second share it has; from speeds that an event has just made zero rounding leaves less. What
/// rested without being held slides again from the third on.
inline constexpr double kNoSliding = 1e-13;
inline constexpr double kAtRest = 1e-11;
inline constexpr double kSlidesAgain = 1e-10;

/// What holds a freedom is none where it is this share of all that adds up to it: closures leave
/// less.
inline constexpr double kNoHold = 1e-12;

/// What stands so near a point of a curve, as share of the curve's range, has come to it.
inline constexpr double kAtPoint = 1e-12;

/// A chord comes no nearer to an end of what it divides than by this share.
inline constexpr double kLeastChord = 1e-3;

}  // namespace kinestat
