// Points of the curve of closed positions by the length of its arc.
#pragma once

#include <array>
#include <cstddef>
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

/// Where points are sought around a place on an arc.
struct Vicinity {
  double place = 0.0;
  double spacing = 0.0;
};

/// Four regular points of an arc around a place that is none; between them everything follows
/// cubics.
struct Surroundings {
  /// A part of the closure that may be singular there by itself.
  struct Part {
    int part = -1;                            ///< index of a block; -1: the whole
    std::array<double, 4> determinants = {};  ///< relative to where the arc begins
    double reciprocal_condition = 0.0;        ///< at the last point
  };

  std::vector<double> places;  ///< along the arc
  std::vector<ArcPoint> points;
  std::vector<Part> parts;

  /// Whether the drives go on at all of the points.
  bool runs_on() const;

  double share_at(double place) const;
  double determinant_at(std::size_t part, double place) const;

  /// How far along the arc the zero of the determinant may be off: by the bend of its four values
  /// if they lie far apart, by rounding, which leaves points across the arc, if near.
  double uncertainty(std::size_t part) const;
  ArcPoint point_at(double place) const;
};

/// Where a part of the closure is singular.
struct ChangePlace {
  double place = 0.0;        ///< along the arc
  double uncertainty = 0.0;  ///< likewise
};

/// A change point on an arc, or several so near each other that they share their surroundings.
struct Crossing {
  std::vector<ChangePlace> places;  ///< of each part that is singular there, rising
  Surroundings around;
  bool is_noted = false;  ///< among what was passed

  double first() const { return places.front().place; }

  double last() const { return places.back().place; }

  double uncertainty() const;

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
