// Numbers that move: over time, or over the position or the speed of an actuator.
#pragma once

#include <optional>
#include <vector>

#include "description/value.hpp"

namespace kinestat {

/// What lies between the points of a curve, in the order of the words in files.
enum class CurveCourse {
  linear,    ///< straight lines
  monotone,  ///< cubics as monotone as the points
  cubic      ///< a spline whose second derivative is continuous
};

/// What such a spline does at its ends, in the order of the words in files.
enum class CurveEnds {
  natural,  ///< no second derivative
  rest,     ///< no slope
  periodic  ///< it goes on as it began
};

/// What a curve is over, if not over the position of an actuator.
inline constexpr const char* kTimeWord = "time";
inline constexpr const char* kSpeedSuffix = ".speed";

struct CurvePointDescription {
  Value at;
  Value value;
};

struct CurveDescription {
  Name name;
  Name over;  ///< kTimeWord, an actuator, or an actuator with kSpeedSuffix
  std::optional<Value> period;
  std::vector<CurvePointDescription> points;
  CurveCourse between = CurveCourse::linear;
  std::optional<CurveEnds> ends = {};
  std::string table = {};       ///< the file that replaced the points; empty if none did
  std::string table_hash = {};  ///< its SHA-256
};

}  // namespace kinestat
