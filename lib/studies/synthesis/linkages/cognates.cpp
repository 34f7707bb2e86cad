#include "studies/synthesis/linkages/cognates.hpp"

#include <algorithm>
#include <cmath>

#include "core/rounding.hpp"
#include "core/tolerance.hpp"
#include "math/numbers/zero_within_bound.hpp"

namespace kinestat {

namespace {

// Where a point is, and by how much each coordinate may be off.
struct SurePlace {
  Point at;
  double bound = 0.0;

  Point settled_point() const {
    return {zero_within_bound(at.real(), bound), zero_within_bound(at.imag(), bound)};
  }
};

SurePlace place_of(const Point& at, const Point& bound, double terms) {
  return {.at = at, .bound = std::abs(bound) + kDataRounding * terms};
}

FourBarPlaces places_of(const SurePlace& fixed_one,
                        const SurePlace& fixed_other,
                        const SurePlace& moving_one,
                        const SurePlace& moving_other) {
  FourBarPlaces result;
  result.fixed = {fixed_one.settled_point(), fixed_other.settled_point()};
  result.moving = {moving_one.settled_point(), moving_other.settled_point()};
  const auto& [fixed, moving, lengths] = result;
  result.lengths = {.ground = std::abs(fixed[1] - fixed[0]),
                    .crank_one = std::abs(moving[0] - fixed[0]),
                    .coupler = std::abs(moving[1] - moving[0]),
                    .crank_other = std::abs(moving[1] - fixed[1])};
  return result;
}

// A link from one place to another, turned and stretched, put at a third.
SurePlace moved(const SurePlace& at,
                const SurePlace& factor,
                const SurePlace& from,
                const SurePlace& to) {
  const Point link = to.at - from.at;
  const Point arm = factor.at * link;
  return {.at = at.at + arm,
          .bound = at.bound + factor.bound * std::abs(link) +
                   std::abs(factor.at) * (from.bound + to.bound) +
                   kDataRounding * (std::abs(at.at) + std::abs(arm))};
}

SurePlace quotient(const SurePlace& a_from,
                   const SurePlace& a_to,
                   const SurePlace& b_from,
                   const SurePlace& b_to) {
  const Point divisor = b_to.at - b_from.at;
  const Point value = (a_to.at - a_from.at) / divisor;
  return {.at = value,
          .bound = (a_from.bound + a_to.bound + std::abs(value) * (b_from.bound + b_to.bound)) /
                       std::abs(divisor) +
                   kDataRounding * std::abs(value)};
}

}  // namespace

std::optional<Cognates> find_cognates(const Linkage& linkage,
                                      const Pose& pose,
                                      const Point& tracer) {
  if (linkage.type() != LinkageType::four_bar) {
    return std::nullopt;
  }
  const auto fixed = [](const Dyad& dyad) {
    return place_of(dyad.centre_point, dyad.centre_bound, 0.0);
  };
  const auto moving = [&](const Dyad& dyad) {
    return place_of(pose.place(dyad.circle_point),
                    dyad.circle_bound,
                    std::abs(pose.origin) + std::abs(dyad.circle_point));
  };
  const SurePlace a0 = fixed(linkage.one);
  const SurePlace b0 = fixed(linkage.other);
  const SurePlace a = moving(linkage.one);
  const SurePlace b = moving(linkage.other);
  const SurePlace e =
      place_of(pose.place(tracer), {0.0, 0.0}, std::abs(pose.origin) + std::abs(tracer));
  const double coupler = std::abs(b.at - a.at);
  const double nearer = std::min(std::abs(e.at - a.at), std::abs(e.at - b.at));
  if (!(coupler > 0.0) || !(nearer > kSameValue * coupler)) {
    return std::nullopt;
  }
  // λ turns and stretches AB into AE; it does the same to the ground.
  const SurePlace share = quotient(a, e, a, b);
  const SurePlace rest = quotient(e, b, a, b);
  const SurePlace whole = {.at = {1.0, 0.0}};
  const SurePlace third = moved(a0, share, a0, b0);
  return Cognates{
      .third_pivot = third.settled_point(),
      .linkages = {places_of(a0, third, moved(a0, whole, a, e), moved(third, share, b0, b)),
                   places_of(b0, third, moved(b0, whole, b, e), moved(third, rest, a0, a))}};
}

}  // namespace kinestat
