// The special frame of an instant: its pole, its inflection circle, and what follows from them.
#pragma once

#include <optional>
#include <vector>

#include "studies/synthesis/dyads/precise_point.hpp"
#include "studies/synthesis/positions/position_jets.hpp"

namespace kinestat {

/// How far what a special frame holds may be off, coordinate by coordinate [length].
struct FrameBounds {
  Point pole = {0.0, 0.0};
  Point turned_diameter = {0.0, 0.0};  ///< of i d e^{iθ}, from the pole to the inflection pole
  std::vector<Point> derivatives = {};
};

/// The special reference frame (pt: sistema especial de referência) has its origin in the pole, x
/// along the pole tangent and y along the pole normal towards the inflection circle; both the fixed
/// and the moving frame lie in it at that instant. do Valle 1983, section 2.3, p. 13.
template <class Scalar>
struct SpecialFrameOf {
  PointOf<Scalar> pole;  ///< [length], fixed frame
  Scalar diameter{0};    ///< d of the inflection circle [length]; α2 = 0, β2 = d
  Scalar angle{0};       ///< θ of x from the x axis of the fixed frame [rad]

  /// a_k + i b_k: derivative k by the angle of the pole point of the plane, k = 0 to n - 1, in this
  /// frame [length]. The first three are 0, 0, i d.
  std::vector<PointOf<Scalar>> derivatives = {};

  /// How far they may be off, coordinate by coordinate; none where nothing is known.
  FrameBounds bounds = {};

  /// A point given in the fixed frame, in this one.
  PointOf<Scalar> from_fixed(const PointOf<Scalar>& point) const;
};

using SpecialFrame = SpecialFrameOf<double>;

struct Circle {
  Point centre;
  double radius = 0.0;
};

/// Reciprocals of M and N [1/length]: the cubic of stationary curvature in polar coordinates of the
/// special frame is 1/r = 1/(M sin φ) + 1/(N cos φ); zero where it falls apart into circle and
/// line.
struct StationaryCurvature {
  double inverse_m = 0.0;
  double inverse_n = 0.0;
};

/// Needs three derivatives of the pose at least: the order is 3, 4 or 5. Empty if the plane does
/// not turn there, or so slowly that lengths above kLargestNumber follow.
std::optional<SpecialFrame> find_special_frame(const PositionJets& position);

/// The position whose moving frame has its origin at `at` and stands at `angle`, by the angle as
/// parameter: the way back. `Scalar` is double or BigFloat.
template <class Scalar>
PositionJetsOf<Scalar> jets_of(const SpecialFrameOf<Scalar>& frame,
                               const PointOf<Scalar>& at,
                               const Scalar& angle);

/// The point about which the plane turns at the instant; empty if it does not turn, the order is
/// below 2, or the point lies beyond kLargestNumber.
std::optional<Point> find_pole(const PositionJets& position);

/// Points whose paths have an inflection there.
Circle inflection_circle(const SpecialFrame& frame);

/// The reflection of the inflection circle at the pole tangent: centres of curvature of points at
/// infinity.
Circle cuspidal_circle(const SpecialFrame& frame);

/// Empty below order 4, or if d = 0.
std::optional<StationaryCurvature> find_stationary_curvature(const SpecialFrame& frame);

/// The point whose path is straightest, where inflection circle and cubic meet [fixed frame]. Empty
/// below order 4, or if every point of the inflection circle has that property.
std::optional<Point> find_ball_point(const SpecialFrame& frame);

}  // namespace kinestat
