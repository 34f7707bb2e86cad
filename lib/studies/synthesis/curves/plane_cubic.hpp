// Circular cubics: the curves of circle points and centre points of four positions.
#pragma once

#include <array>
#include <optional>

#include "studies/synthesis/positions/plane.hpp"
#include "studies/synthesis/positions/special_frame.hpp"

namespace kinestat {

/// The points Z whose normal . Z is offset; the normal has length 1.
struct PlaneLine {
  Point normal = {1.0, 0.0};
  double offset = 0.0;  ///< [length]
};

/// How far the coefficients of a cubic may be off, in their order.
struct CubicBounds {
  std::array<double, 2> k{};
  std::array<double, 3> q{};
  std::array<double, 2> l{};
  double c = 0.0;
};

/// (u² + v²)(k1 u + k2 v) + q11 u² + q12 uv + q22 v² + l1 u + l2 v + c = 0 for the points
/// Z = centre + length (u + iv); the largest coefficient is 1.
struct PlaneCubic {
  std::array<double, 2> k{};
  std::array<double, 3> q{};  ///< q11, q12, q22
  std::array<double, 2> l{};
  double c = 0.0;
  Point centre = {0.0, 0.0};  ///< [length], fixed frame
  double length = 1.0;        ///< the unit of u and v
  CubicBounds bounds = {};    ///< zero where nothing is known

  /// The left side at Z, by the sum of the sizes of its terms: rounding on the curve.
  double miss(const Point& point) const;

  /// The tangents in the circular points at infinity meet in it; it lies on the curve. Empty if the
  /// curve is a conic.
  std::optional<Point> focus() const;

  /// The only real one. Empty if the curve is a conic.
  std::optional<PlaneLine> asymptote() const;

  /// Of a conic, if it is a circle. Of three parallel positions and one that is turned the circle
  /// points, and the centres, are one.
  std::optional<Circle> circle() const;

  /// Of a conic, if it is a straight line. Empty if all of it lies at infinity.
  std::optional<PlaneLine> line() const;

  /// The direction of (k1, k2), across the asymptote; of a conic that of u.
  Point normal() const;

  /// The terms with q11, q12 and q22 at a vector of u and v.
  double quadratic(const Point& e) const;

  /// The same curve in u, v about another centre and in another unit, such as 0 and 1. Its
  /// coefficients have no bounds.
  PlaneCubic about(const Point& new_centre, double new_length) const;

  /// The same with bounds, and zero where these do not tell a coefficient from zero.
  PlaneCubic settled_about(const Point& new_centre, double new_length) const;
};

}  // namespace kinestat
