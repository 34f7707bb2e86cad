// How the drives of a motion run in time.
#pragma once

#include <cstddef>
#include <vector>

#include "description/drive_law.hpp"

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

/// Of one drive: by a law from one end of its range to the other or, without one, by a speed and an
/// acceleration that stay as they are.
struct DriveCourse {
  double from = 0.0;  ///< [rad or m]
  double to = 0.0;
  double speed = 0.0;         ///< at the beginning, without a law
  double acceleration = 0.0;  ///< likewise
};

/// All drives together, in steps of equal time.
class DriveSchedule {
 public:
  /// By a law.
  DriveSchedule(double duration, std::vector<DriveCourse> courses, DriveLaw law, double ramp);

  /// With steady accelerations.
  DriveSchedule(double duration, std::vector<DriveCourse> courses);

  double duration() const { return duration_; }  ///< [s]

  /// Whether the drives keep the proportion of their ranges and never turn back, so that a share of
  /// the ranges tells a place.
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

  /// Whether the law's speed jumps at its ends.
  bool has_jumps() const { return has_law_ && law_ == DriveLaw::constant_speed; }

 private:
  double duration_ = 1.0;
  std::vector<DriveCourse> courses_;
  bool has_law_ = false;
  DriveLaw law_ = DriveLaw::constant_speed;
  double ramp_ = kUsualRamp;
  bool is_straight_ = true;
};

}  // namespace kinestat
