#include "studies/synthesis/dyads/given_dyad.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "studies/synthesis/curves/curve_point.hpp"
#include "studies/synthesis/dyads/few_positions.hpp"
#include "studies/synthesis/dyads/internal/condition_rows.hpp"
#include "studies/synthesis/linkages/linkage.hpp"

namespace kinestat {

namespace {

constexpr DyadPoint other_than(DyadPoint which) {
  return which == DyadPoint::circle_point ? DyadPoint::centre_point : DyadPoint::circle_point;
}

Point foot_on(const PlaneLine& line, const Point& point) {
  return point + (line.offset - dot(line.normal, point)) * line.normal;
}

class Completion {
 public:
  Completion(std::span<const PositionJets> positions, const GivenDyad& given)
      : positions_(positions), given_(given) {}

  CompletedDyad run() const {
    const DyadPoint which = given_.circle_point ? DyadPoint::circle_point : DyadPoint::centre_point;
    switch (position_count(positions_)) {
      case 2:
        return on_line(which);
      case 3:
        return of_point(which, in_plane(which));
      default:
        return on_curve(which);
    }
  }

 private:
  // In the fixed frame, at the first position.
  Point in_plane(DyadPoint which) const {
    return frame_of(which, positions_)
        .place(which == DyadPoint::circle_point ? *given_.circle_point : *given_.centre_point);
  }

  Point in_frame(DyadPoint which, const Point& point) const {
    const Pose frame = frame_of(which, positions_);
    return unit_vector(-frame.angle) * (point - frame.origin);
  }

  // As far as points are told apart at all: beside what their decimals leave, no further than
  // reports are. A point that was worked out, or typed with all digits of a double, is as good.
  double allowance(const Point& point) const {
    double size = std::abs(point);
    for (const PositionJets& position : positions_) {
      size = std::max(size, std::abs(origin(position) - point));
    }
    return given_.rounding + kReportsAgree * size;
  }

  CompletedDyad of_point(DyadPoint which, const Point& point) const {
    auto dyad = find_dyad(positions_, point, which);
    return dyad ? CompletedDyad{.dyad = std::move(dyad)}
                : CompletedDyad{.dyad = {}, .fault = GivenFault::open, .which = which};
  }

  CompletedDyad on_curve(DyadPoint which) const {
    const FourPositionCurves curves = find_curves(positions_);
    const Point point = in_plane(which);
    const std::optional<Point> nearest = curves.status == BurmesterStatus::solved
                                             ? find_nearest(curves.of(which), point)
                                             : std::nullopt;
    if (!nearest) {
      return {.dyad = {}, .fault = GivenFault::open, .which = which};
    }
    const double distance = std::abs(*nearest - point);
    if (distance > allowance(point)) {
      return {.dyad = {},
              .fault = GivenFault::off_curve,
              .which = which,
              .instead = in_frame(which, *nearest),
              .distance = distance};
    }
    return of_point(which, *nearest);
  }

  CompletedDyad on_line(DyadPoint which) const {
    const Point point = in_plane(which);
    const DyadPoint other = other_than(which);
    const std::optional<PlaneLine> line = find_partner_line(positions_, point, which);
    const bool has_both = given_.circle_point && given_.centre_point;
    if (!line && !has_both) {
      return {.dyad = {}, .fault = GivenFault::open, .which = which};
    }
    const Point wanted = has_both ? in_plane(other) : point;
    const Point foot = line ? foot_on(*line, wanted) : wanted;
    const double distance = std::abs(foot - wanted);
    if (has_both && distance <= 2.0 * allowance(wanted)) {
      return {.dyad = which == DyadPoint::circle_point ? make_crank(positions_, point, foot)
                                                       : make_crank(positions_, foot, point)};
    }
    // Where the given point lies on that line itself, as of PP, the crank still has a length.
    const bool is_there = !has_both && distance <= allowance(wanted);
    const Point along = left_of(line->normal);
    const Point instead = is_there ? foot + make_condition_rows(positions_).length * along : foot;
    return {.dyad = {},
            .fault = has_both ? GivenFault::off_line : GivenFault::one_alone,
            .which = other,
            .instead = in_frame(other, instead),
            .along = unit_vector(-frame_of(other, positions_).angle) * along,
            .distance = distance};
  }

  std::span<const PositionJets> positions_;
  const GivenDyad& given_;
};

}  // namespace

CompletedDyad complete_dyad(std::span<const PositionJets> positions, const GivenDyad& given) {
  KINESTAT_EXPECTS(given.circle_point || given.centre_point);
  KINESTAT_EXPECTS(position_count(positions) >= 2 && position_count(positions) <= 4);
  return Completion(positions, given).run();
}

}  // namespace kinestat
