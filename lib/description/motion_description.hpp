// The section `motion`: a finite motion from the drawn position.
#pragma once

#include <optional>
#include <vector>

#include "description/drive_law.hpp"
#include "description/value.hpp"

namespace kinestat {

/// A part of how a drive runs: to a place by a law, or a dwell.
struct ProfilePart {
  std::optional<Value> to;
  std::optional<Value> time;
  std::optional<DriveLaw> law;
  std::optional<Value> ramp;   ///< of a trapezoid
  std::optional<Value> dwell;  ///< for how long it stays, instead of all these
  SourceRange where;
};

/// One drive and the range it runs through, measured from the drawn position.
struct DriveRange {
  Name actuator;
  std::optional<Value> from;
  std::optional<Value> to;  ///< or where it turns back: `limit_sense`; may be missing where the
                            ///< motion has a time
  std::vector<ProfilePart> profile = {};  ///< instead of `to`
  std::optional<Name> curve = {};         ///< likewise, over time
  SourceRange where = {};                 ///< of one of several

  /// Whether it says by itself how the drive runs in time.
  bool has_course() const { return !profile.empty() || curve.has_value(); }
};

/// `to: limit` runs until the drive turns back, `to: -limit` does so backwards.
inline constexpr const char* kLimitWord = "limit";
inline constexpr const char* kLimitBackwards = "-limit";

/// A point of a body whose path is reported.
struct TracePoint {
  Name body;
  PointDescription at;
  std::optional<Name> name = {};  ///< empty: BODY.N, the N-th of all
};

/// Where the file does not say how many.
inline constexpr int kUsualSteps = 100;

struct MotionDescription {
  std::vector<DriveRange> drives;
  std::optional<Value> steps;
  std::optional<Value> time = {};    ///< the whole: then steps are equal in time
  std::optional<DriveLaw> law = {};  ///< of all drives; needs a time
  std::optional<Value> ramp = {};    ///< of a trapezoid
  std::optional<Name> label;         ///< of the case that gives speeds and loads
  std::vector<TracePoint> trace;
  std::vector<Name> report;  ///< `velocity`, `acceleration`, … or coupling.freedom
  bool is_another = false;   ///< options gave another drive, way or case than the file does
  SourceRange where;
};

}  // namespace kinestat
