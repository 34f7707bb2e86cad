// A curve through points: a number that depends on time, or on the position or speed of a freedom.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/source.hpp"
#include "expression/quantity.hpp"
#include "math/dense/interpolation.hpp"

namespace kinestat {

/// A curve in SI. Values without a unit are in the unit of the number that uses the curve.
struct Curve {
  enum class Over { time, position, speed };

  std::string name;
  Over over = Over::time;
  int freedom = -1;            ///< the freedom whose position or speed counts; -1: time
  std::string actuator;        ///< the actuator of this freedom that the file names
  std::vector<double> at;      ///< arguments of the points, ascending [s, rad, m, rad/s or m/s]
  std::vector<double> values;  ///< at the points
  std::vector<double> slopes;  ///< at the points; empty: straight lines between them
  std::optional<double> period;
  Dimension dimension;  ///< of the values
  SourceRange where;

  /// The kind of its argument.
  QuantityKind place_kind = QuantityKind::time;

  /// The point at an argument; empty outside the ends of a curve without a period.
  std::optional<CurvePoint> point(double place) const;
};

}  // namespace kinestat
