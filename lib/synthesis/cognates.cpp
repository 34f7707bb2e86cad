#include "synthesis/cognates.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"

namespace kinestat {

namespace {

FourBarPlaces places_of(std::array<Point, 2> fixed, std::array<Point, 2> moving) {
  const FourBarLengths lengths{.ground = std::abs(fixed[1] - fixed[0]),
                               .crank_one = std::abs(moving[0] - fixed[0]),
                               .coupler = std::abs(moving[1] - moving[0]),
                               .crank_other = std::abs(moving[1] - fixed[1])};
  return {.fixed = fixed, .moving = moving, .lengths = lengths};
}

}  // namespace

std::optional<Cognates> find_cognates(const Linkage& linkage,
                                      const Pose& pose,
                                      const Point& tracer) {
  if (linkage.type() != LinkageType::four_bar) {
    return std::nullopt;
  }
  const Point a0 = linkage.one.centre_point;
  const Point b0 = linkage.other.centre_point;
  const Point a = pose.place(linkage.one.circle_point);
  const Point b = pose.place(linkage.other.circle_point);
  const Point e = pose.place(tracer);
  const double nearer = std::min(std::abs(e - a), std::abs(e - b));
  if (!(std::abs(b - a) > 0.0) || !(nearer > kSameValue * std::abs(b - a))) {
    return std::nullopt;
  }
  // λ turns and stretches AB into AE; it does the same to the ground.
  const Point share = (e - a) / (b - a);
  const Point rest = 1.0 - share;
  const Point third = a0 + share * (b0 - a0);
  return Cognates{
      .third_pivot = third,
      .linkages = {places_of({a0, third}, {a0 + share * (b - a), third + share * (b - b0)}),
                   places_of({b0, third}, {b0 - rest * (b - a), third + rest * (a - a0)})}};
}

}  // namespace kinestat
