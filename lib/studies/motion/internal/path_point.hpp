// Points of the way that the drives take, and what must be known to go on from one.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "studies/motion/internal/arc_point.hpp"

namespace kinestat {

/// A closed position on the way. Buffers are used again and again.
struct PathPoint {
  double share = 0.0;
  std::vector<double> coordinates;
  std::vector<double> angles;
  std::vector<double> rates;        ///< of all joints, by the share
  std::vector<double> matrix;       ///< of the closure towards the unknowns, where it is not square
  std::vector<double> arrival;      ///< the step of all joints that led here
  double arrival_share = 0.0;       ///< by how much the share grew with it; 0: none
  double sign = 0.0;                ///< of the determinant of the closure, where it is square
  std::vector<double> block_signs;  ///< likewise, of each of its blocks where it has several
  double closure_error = 0.0;
  double reciprocal_condition = 0.0;
  bool is_singular = false;  ///< the drives do not determine the rates
};

/// How a way to the next position ended.
enum class Arrival { reached, limit, lift_off, lost };

/// Of a point beside a change point: the regular ones before and behind both on the arc.
struct Resumption {
  ArcPoint before;
  std::optional<ArcPoint> behind;  ///< unknown after the drives have left their line
  bool is_at = false;              ///< the change point itself
  bool has_passed = false;         ///< the way has passed it, or it is told
};

/// Before a stretch of the way.
struct Beginning {
  PathPoint point;
  std::optional<Resumption> resumption;
  std::size_t passed = 0;  ///< special positions
};

/// How far a cable is from leaving its pulley.
struct LeastArc {
  double arc = 0.0;  ///< negative: it runs straight past there
  int contact = -1;
};

}  // namespace kinestat
