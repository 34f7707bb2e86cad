// How the drives of a motion run in time.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "description/drive_law.hpp"
#include "mechanism/curves/curve.hpp"

namespace kinestat {

/// A point of a drive law: the share of the range that is covered at a share of the time, and its
/// derivatives with respect to the share of the time. Where the second derivative jumps, it is the
/// value after the jump; at the end it is the value before.
struct LawPoint {
  double share = 0.0;
  double slope = 0.0;  ///< first derivative
  double bend = 0.0;   ///< second derivative
};

/// The point of a law at the share `time`, from 0 to 1. `ramp` is used by the trapezoid only.
LawPoint law_at(DriveLaw law, double ramp, double time);

/// The state of a drive at an instant, in rad or m and s. Its position is from the drawn one.
struct DriveInstant {
  double position = 0.0;
  double speed = 0.0;
  double acceleration = 0.0;
};

/// A part of a course, in which a drive moves to another position by a law. It dwells if the two
/// positions are the same.
struct CoursePart {
  double begin = 0.0;  ///< as a share of the whole time
  double end = 1.0;
  double from = 0.0;  ///< [rad or m]
  double to = 0.0;
  DriveLaw law = DriveLaw::polynomial_345;
  double ramp = kUsualRamp;
};

/// The course of one drive in time: by parts, by a curve or, without these, with a constant
/// acceleration.
struct DriveCourse {
  double from = 0.0;  ///< [rad or m]
  double to = 0.0;
  double speed = 0.0;                            ///< at the beginning [rad/s or m/s]
  double acceleration = 0.0;                     ///< constant [rad/s² or m/s²]
  std::vector<CoursePart> parts = {};            ///< in order of time; after them the drive rests
  std::shared_ptr<const Curve> curve = nullptr;  ///< position over time [rad or m]

  bool is_steady() const { return parts.empty() && curve == nullptr; }
};

/// The courses of all drives of a motion.
class DriveSchedule {
 public:
  DriveSchedule(double duration, std::vector<DriveCourse> courses);

  double duration() const { return duration_; }  ///< [s]

  /// Whether all drives cover equal shares of their ranges at any time and never reverse or dwell,
  /// so that a share of the ranges identifies a position.
  bool is_straight() const { return is_straight_; }

  /// The state of a drive at the share `time` of the duration.
  DriveInstant at(std::size_t drive, double time) const;

  /// The share of the time at which straight drives have covered this share of their ranges.
  double time_of(double share) const;

  /// The share of the time at the position that a motion identifies by `share`: this is a share of
  /// the ranges if the drives run straight, otherwise of the time.
  double time_at(double share) const { return is_straight_ ? time_of(share) : share; }

  /// The inverse of time_at.
  double share_at(double time) const;

  /// The shares of the time at which a speed jumps, in order and each once.
  std::vector<double> jumps() const;

  /// The shares of the time, without its ends and in order, at which a speed or an acceleration may
  /// jump. `before` gives a time just before such a jump, which still has the values before it.
  std::vector<double> breaks() const;
  static double before(double jump);

  /// The shares of the time, in order, without 0 and 1, between which each drive runs one way or
  /// rests.
  std::vector<double> turns() const;

  /// Likewise, between which the acceleration of each drive is smooth.
  std::vector<double> corners() const;

  std::size_t drive_count() const { return courses_.size(); }

 private:
  std::vector<double> ends_of_parts() const;
  void add_turns(std::size_t drive, double from, double to, std::vector<double>& turns) const;

  double duration_ = 1.0;
  std::vector<DriveCourse> courses_;
  bool is_straight_ = true;
};

}  // namespace kinestat
