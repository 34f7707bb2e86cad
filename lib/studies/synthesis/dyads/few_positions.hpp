// Two, three and four positions: dyads in families, ordered by circle point or by centre.
#pragma once

#include <optional>
#include <span>

#include "studies/synthesis/curves/plane_cubic.hpp"
#include "studies/synthesis/dyads/burmester.hpp"
#include "studies/synthesis/dyads/dyad.hpp"
#include "studies/synthesis/positions/position_jets.hpp"
#include "studies/synthesis/positions/special_frame.hpp"

namespace kinestat {

/// Four positions in any grouping: the points that stay on a circle lie on a cubic, and so do their
/// centres.
struct FourPositionCurves {
  BurmesterStatus status = BurmesterStatus::solved;  ///< `family`: every point, see `reason`
  Degeneracy reason = Degeneracy::none;
  PlaneCubic circle_points;             ///< fixed frame, at the first position
  PlaneCubic centre_points;             ///< fixed frame
  std::optional<Dyad> slider;           ///< the only point on a straight path
  std::optional<Dyad> inverted_slider;  ///< the only line through a fixed point
  double reciprocal_condition = 0.0;
  double digits = 16.0;

  const PlaneCubic& of(DyadPoint which) const {
    return which == DyadPoint::circle_point ? circle_points : centre_points;
  }
};

FourPositionCurves find_curves(std::span<const PositionJets> positions);

/// The dyad of a circle point, or of a centre point, that is given in the fixed frame at the first
/// position, for three positions, or for four of which the point lies on the curve (where it does
/// not, the dyad misses positions, see its residual). Its other point is the best of the conditions
/// in pairs; a slider, or an inverted one, if that lies far away. Empty if the positions leave it
/// open.
std::optional<Dyad> find_dyad(std::span<const PositionJets> positions,
                              const Point& point,
                              DyadPoint which = DyadPoint::circle_point);

/// Two positions: the line of the centres of a circle point, or of the circle points of a centre,
/// fixed frame at the first position; of P-P the perpendicular bisector of both places. Empty if
/// the positions leave open what belongs to the point, or nothing does.
std::optional<PlaneLine> find_partner_line(std::span<const PositionJets> positions,
                                           const Point& point,
                                           DyadPoint which);

/// The crank of a circle point and its centre, both in the fixed frame at the first position.
std::optional<Dyad> make_crank(std::span<const PositionJets> positions,
                               const Point& circle_point,
                               const Point& centre_point);

/// Three positions: the points whose places lie on a straight line, fixed frame, at the first
/// position; of PPP the inflection circle. Empty if the plane only translates.
std::optional<Circle> find_straight_path_circle(std::span<const PositionJets> positions);

}  // namespace kinestat
