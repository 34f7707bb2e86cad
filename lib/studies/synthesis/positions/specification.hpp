// Positions given by what an engineer knows of them: a pole, curvatures, circle points.
#pragma once

#include <optional>

#include "studies/synthesis/dyads/precise_point.hpp"
#include "studies/synthesis/positions/position_jets.hpp"

namespace kinestat {

/// What fixes the inflection circle: the centre of curvature of the path of E, the origin of the
/// moving frame, and the shape of the curvature of another point F. do Valle 1983, 2.2, p. 8.
template <class Scalar>
struct CurvatureSpecificationOf {
  PointOf<Scalar> centre;      ///< O_E, fixed frame, on the line from E to the pole
  PointOf<Scalar> free_point;  ///< F, fixed frame, not on that line

  /// m: the centre of curvature of F lies at O_F = F + m (P - F); below zero on the other side of F
  /// than the pole, above one beyond the pole, infinite on a straight path. Not zero.
  Scalar ratio{1};
};

using CurvatureSpecification = CurvatureSpecificationOf<double>;

/// Each condition needs the one before. With a pole the group is PP, with curvature PPP, with
/// stationary curvature of E and F PPPP, and if both are Burmester points PPPPP.
template <class Scalar>
struct PositionSpecificationOf {
  PointOf<Scalar> at;  ///< E [length], fixed frame
  Scalar angle{0};     ///< of the moving frame [rad]
  std::optional<PointOf<Scalar>> pole = std::nullopt;
  std::optional<CurvatureSpecificationOf<Scalar>> curvature = std::nullopt;
  bool is_stationary = false;
  bool is_burmester = false;
};

using PositionSpecification = PositionSpecificationOf<double>;

/// Why no motion meets a specification.
enum class SpecificationFault {
  none,
  point_in_pole,        ///< E is the pole: its path has a cusp and no centre to be given
  free_point_in_pole,   ///< F is the pole
  aligned_points,       ///< E, F and the pole on one line: two conditions say the same
  centre_off_normal,    ///< O_E is not on the line from E to the pole
  centre_in_point,      ///< O_E is E: the path would have no radius
  zero_ratio,           ///< m is zero: the path of F would have no radius
  no_inflection_circle  ///< the inflection circle is a point: no higher curvature can be prescribed
};

/// What the conditions of E alone leave free: of the free point F and its ratio m only this
/// matters, one number for each order. do Valle 1983, recommendation 5.2.
struct EffectiveFreedom {
  double s = 0.0;      ///< component of the vector from pole to inflection pole to the left of the
                       ///< direction from the pole to E [length]
  double tau = 0.0;    ///< of (d/M, d/N) likewise, in the special frame; plain number
  double tau_2 = 0.0;  ///< of the fourth derivative (α4, β4)/d likewise; plain number
};

template <class Scalar>
struct SpecifiedPositionOf {
  std::optional<PositionJetsOf<Scalar>> jets;  ///< by the angle; empty if there is a fault
  SpecificationFault fault = SpecificationFault::none;
};

using SpecifiedPosition = SpecifiedPositionOf<double>;

/// Free of the divisions by cosines, tangents and coordinates of the pole that fail in the source;
/// its equation 2.53 in the corrected form.
SpecifiedPosition find_jets(const PositionSpecification& specification);

/// With the digits of BigFloat.
SpecifiedPositionOf<BigFloat> find_precise_jets(
    const PositionSpecificationOf<BigFloat>& specification);

/// The same for the conditions of E alone: pole, centre of curvature of its path, and whether it is
/// a point of the cubic and a Burmester point. The free point and its ratio are not looked at.
SpecifiedPosition find_jets(const PositionSpecification& specification,
                            const EffectiveFreedom& freedom);

}  // namespace kinestat
