#include "synthesis/cognates.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"

namespace kinestat {

namespace {

FourBarPlaces places_of(const BoundedPoint& fixed_one,
                        const BoundedPoint& fixed_other,
                        const BoundedPoint& moving_one,
                        const BoundedPoint& moving_other) {
  FourBarPlaces result;
  result.fixed = {fixed_one.zeroed(), fixed_other.zeroed()};
  result.moving = {moving_one.zeroed(), moving_other.zeroed()};
  const auto& [fixed, moving, lengths] = result;
  result.lengths = {.ground = std::abs(fixed[1] - fixed[0]),
                    .crank_one = std::abs(moving[0] - fixed[0]),
                    .coupler = std::abs(moving[1] - moving[0]),
                    .crank_other = std::abs(moving[1] - fixed[1])};
  return result;
}

}  // namespace

std::optional<Cognates> find_cognates(const Linkage& linkage,
                                      const Pose& pose,
                                      const Point& tracer) {
  if (linkage.type() != LinkageType::four_bar) {
    return std::nullopt;
  }
  const BoundedPoint a0 = linkage.one.bounded_centre_point();
  const BoundedPoint b0 = linkage.other.bounded_centre_point();
  const BoundedPoint a = pose.bounded_place(linkage.one.bounded_circle_point());
  const BoundedPoint b = pose.bounded_place(linkage.other.bounded_circle_point());
  const BoundedPoint e = pose.bounded_place(BoundedPoint::written(tracer));
  const double coupler = std::abs((b - a).value());
  const double nearer = std::min(std::abs((e - a).value()), std::abs((e - b).value()));
  if (!(coupler > 0.0) || !(nearer > kSameValue * coupler)) {
    return std::nullopt;
  }
  // λ turns and stretches AB into AE; it does the same to the ground.
  const BoundedPoint share = (e - a) / (b - a);
  const BoundedPoint rest = (b - e) / (b - a);
  const BoundedPoint third = a0 + share * (b0 - a0);
  return Cognates{.third_pivot = third.zeroed(),
                  .linkages = {places_of(a0, third, a0 + (e - a), third + share * (b - b0)),
                               places_of(b0, third, b0 - (b - e), third + rest * (a - a0))}};
}

}  // namespace kinestat
