// A number that moves, through points.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/source.hpp"
#include "expression/quantity.hpp"
#include "math/dense/interpolation.hpp"

namespace kinestat {

/// In SI; values without a unit count in that of the file where the curve is used.
struct Curve {
  enum class Over { time, position, speed };

  std::string name;
  Over over = Over::time;
  int freedom = -1;            ///< whose position or speed, index into Topology::freedoms
  std::string actuator;        ///< of that freedom, as the file names it
  std::vector<double> at;      ///< rising [s, rad, m, rad/s or m/s]
  std::vector<double> values;  ///< at these
  std::vector<double> slopes;  ///< likewise; empty: straight lines between the points
  std::optional<double> period;
  Dimension dimension;  ///< of the values
  SourceRange where;

  /// What its places measure.
  QuantityKind place_kind = QuantityKind::time;

  /// Empty beyond its ends, where it has no period.
  std::optional<CurvePoint> point(double place) const;
};

}  // namespace kinestat
