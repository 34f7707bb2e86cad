// The section `motion`: a finite motion from the drawn position.
#pragma once

#include <optional>
#include <vector>

#include "description/value.hpp"

namespace kinestat {

/// One drive and the range it runs through, measured from the drawn position.
struct DriveRange {
  Name actuator;
  std::optional<Value> from;
  std::optional<Value> to;  ///< or where it turns back: `limit_sense`
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
  std::optional<Name> label;  ///< of the case that gives speeds and loads
  std::vector<TracePoint> trace;
  std::vector<Name> report;  ///< `velocity`, `acceleration`, … or coupling.freedom
  SourceRange where;
};

}  // namespace kinestat
