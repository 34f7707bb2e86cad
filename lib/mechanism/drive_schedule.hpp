// How the drives of a motion run in time.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "description/drive_law.hpp"
#include "mechanism/curves/curve.hpp"

namespace kinestat {

/// The share of a range at a share of the time, and its derivatives towards the latter. Where a
/// second derivative jumps it is that behind the jump, at the end that before.
struct LawPoint {
  double share = 0.0;
  double slope = 0.0;
  double bend = 0.0;
};

/// `time` from 0 to 1; `ramp` counts for a trapezoid alone.
LawPoint law_at(DriveLaw law, double ramp, double time);

/// Where a drive is at an instant, from the drawn position, and how it moves: rad or m, and s.
struct DriveInstant {
  double position = 0.0;
  double speed = 0.0;
  double acceleration = 0.0;
};

/// To a place by a law, within a part of the time; without a way it rests.
struct CoursePart {
  double begin = 0.0;  ///< share of the whole time
  double end = 1.0;
  double from = 0.0;  ///< [rad or m]
  double to = 0.0;
  DriveLaw law = DriveLaw::polynomial_345;
  double ramp = kUsualRamp;
};

/// Of one drive: by parts or a curve or, without these, by a speed and an acceleration that stay as
/// they are.
struct DriveCourse {
  double from = 0.0;  ///< [rad or m]
  double to = 0.0;
  double speed = 0.0;                            ///< at the beginning, of a steady course
  double acceleration = 0.0;                     ///< likewise
  std::vector<CoursePart> parts = {};            ///< one behind the other; then it rests
  std::shared_ptr<const Curve> curve = nullptr;  ///< over time, its values in rad or m

  bool is_steady() const { return parts.empty() && curve == nullptr; }
};

/// All drives together, in steps of equal time.
class DriveSchedule {
 public:
  DriveSchedule(double duration, std::vector<DriveCourse> courses);

  double duration() const { return duration_; }  ///< [s]

  /// Whether the drives keep the proportion of their ranges and never turn back or rest, so that a
  /// share of the ranges tells a place.
  bool is_straight() const { return is_straight_; }

  /// At a share of the time.
  DriveInstant at(std::size_t drive, double time) const;

  /// Of drives that run straight: when they have come to that share of their ranges.
  double time_of(double share) const;

  /// When they are at the place that the motion knows by that share: of the time, or of the ranges
  /// of drives that run straight.
  double time_at(double share) const { return is_straight_ ? time_of(share) : share; }

  /// That share at a share of the time.
  double share_at(double time) const;

  /// At which shares of the time a speed jumps.
  std::vector<double> jumps() const;

  /// At which of them on the way an acceleration or a speed may be another before than behind, in
  /// order; `before` is where it is still that before.
  std::vector<double> breaks() const;
  static double before(double jump);

  /// The shares of the time, in order, without 0 and 1, between which each drive runs one way or
  /// rests.
  std::vector<double> turns() const;

 private:
  void add_turns(std::size_t drive, double from, double to, std::vector<double>& turns) const;

  double duration_ = 1.0;
  std::vector<DriveCourse> courses_;
  bool is_straight_ = true;
};

}  // namespace kinestat
