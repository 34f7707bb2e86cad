// Where a cable, belt or chain touches what it runs over.
#pragma once

#include <optional>

#include "math/numbers/dual_vector.hpp"

namespace kinestat {

/// A point on a body or a wrapped pulley, in numbers. World frame, SI. `Scalar` is double or Dual.
template <class Scalar>
struct CableStationGeometryOf {
  Vec3Of<Scalar> centre = Vec3Of<Scalar>::Zero();  ///< the point itself, or the pulley's centre [m]
  Vec3Of<Scalar> axis = Vec3Of<Scalar>::UnitZ();   ///< of the pulley, a unit vector
  Scalar radius = 0.0;  ///< [m] signed: positive where the cable turns about +axis, negative
                        ///< about -axis; 0 for a point
  std::optional<Vec3Of<Scalar>> meets;   ///< where the cable meets and leaves a pulley whose points
  std::optional<Vec3Of<Scalar>> leaves;  ///< the file gives [m]
};

using CableStationGeometry = CableStationGeometryOf<double>;

/// A straight segment: from where it leaves one station to where it meets the next.
template <class Scalar>
struct CableSpanOf {
  Vec3Of<Scalar> from = Vec3Of<Scalar>::Zero();  ///< [m]
  Vec3Of<Scalar> to = Vec3Of<Scalar>::Zero();    ///< [m]
};

using CableSpan = CableSpanOf<double>;

/// Why no straight segment joins two stations.
enum class SpanFault {
  none,
  same_point,     ///< it would have no length
  point_inside,   ///< a point lies within the pulley, or on its rim
  circle_inside,  ///< one pulley lies within the other, and the cable turns alike on both
  overlap,        ///< the cable crosses over between two pulleys that overlap
  out_of_plane    ///< no plane across the axes holds both stations
};

SpanFault find_fault(const CableStationGeometry& a, const CableStationGeometry& b);

/// The segment from `a` to `b`, tangent to both; there must be no fault. Its ends follow the given
/// points where there are any. In words, with c from centre to centre, n the axis and ρ the signed
/// radii: along u = (L c + s c x n)/c², with s = ρ_b - ρ_a and the length L = √(c² - s²), from
/// c_a + ρ_a u x n to c_b + ρ_b u x n. Radii of one sign give the open (external) tangent, of two
/// signs the crossed (internal) one.
template <class Scalar>
CableSpanOf<Scalar> tangent_span(const CableStationGeometryOf<Scalar>& a,
                                 const CableStationGeometryOf<Scalar>& b);

/// From end to end of a segment [m]. A component that the rounding of the ends explains is zero, or
/// a cable that hangs straight down would pull aside; of numbers as typed the difference is exact.
template <class Scalar>
Vec3Of<Scalar> along_segment(const Vec3Of<Scalar>& from, const Vec3Of<Scalar>& to);

/// The angle θ of the contact at a pulley [rad], from 0 to below 2π, between the segment that
/// arrives and the one that leaves, in the sense in which the cable turns.
template <class Scalar>
Scalar wrap_angle(const CableStationGeometryOf<Scalar>& pulley,
                  const CableSpanOf<Scalar>& arrives,
                  const CableSpanOf<Scalar>& leaves);

/// Whether a cable with an arc of this angle, full turns counted, meets itself: the tangents of
/// more than half a turn meet at r |tan(θ/2)| from its ends. `shorter` is the length of the shorter
/// of its two segments [m].
bool crosses_itself(double radius, double angle, double shorter);

/// Whether a segment passes through the disc of a pulley in whose plane it lies. What lies within
/// the share `margin` of the radius inside the rim still passes by.
bool passes_through(const CableSpan& span, const CableStationGeometry& pulley, double margin);

}  // namespace kinestat
