// Points of the curve of closed positions by the length of its arc.
#pragma once

#include <optional>
#include <vector>

namespace kinestat {

/// In the unknown joints and, last, the drives in units of their largest reach.
struct ArcPoint {
  double share = 0.0;
  std::vector<double> coordinates;
  std::vector<double> angles;
  std::vector<double> tangent;
  std::vector<double> matrix;  ///< of the closure: rows x (unknowns + 1)
};

/// From 0 to `high` along an arc, with the values of a function at both ends, of two signs.
struct ArcBracket {
  double high = 0.0;
  double low_value = 0.0;
  double high_value = 0.0;
};

/// Four regular points of an arc around a place that is none; between them everything follows
/// cubics.
struct Surroundings {
  std::vector<double> places;  ///< along the arc
  std::vector<ArcPoint> points;
  std::vector<double> determinants;  ///< of the closure, relative to where the arc begins
  double flatness = 0.0;             ///< of that at the last point

  double share_at(double place) const;
  double determinant_at(double place) const;

  /// How far along the arc the zero of the determinant may be off: by the bend of its four values
  /// if they lie far apart, by rounding, which leaves points across the arc, if near.
  double uncertainty() const;
  ArcPoint point_at(double place) const;
};

/// A change point on an arc.
struct Crossing {
  double place = 0.0;        ///< along the arc
  double uncertainty = 0.0;  ///< likewise
  Surroundings around;
  bool is_noted = false;  ///< among what was passed

  /// Whether the drives have this share between its surroundings.
  bool is_around(double share) const {
    return around.points.front().share <= share && share <= around.points.back().share;
  }
};

/// Where the drives have a share, between the ends of a step of the arc.
struct Destination {
  const ArcPoint& from;
  double share = 0.0;
  ArcBracket passes;                 ///< of the share
  std::optional<Crossing> crossing;  ///< in the same step
};

}  // namespace kinestat
