#include "studies/synthesis/linkages/linkage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/synthesis_tolerance.hpp"
#include "studies/synthesis/linkages/rounded_dyad.hpp"

namespace kinestat {

namespace {

std::array<double, 4> as_array(const FourBarLengths& lengths) {
  return {lengths.ground, lengths.crank_one, lengths.coupler, lengths.crank_other};
}

}  // namespace

std::string_view word_of(LinkageType type) {
  switch (type) {
    case LinkageType::four_bar:
      return "four_bar";
    case LinkageType::slider_crank:
      return "slider_crank";
    case LinkageType::inverted_slider_crank:
      return "inverted_slider_crank";
    case LinkageType::double_slider:
      return "double_slider";
    case LinkageType::slider_inverted_slider:
      return "slider_inverted_slider";
    case LinkageType::double_inverted_slider:
      return "double_inverted_slider";
  }
  return "";
}

LinkageType Linkage::type() const {
  const auto [first, second] = std::minmax(one.kind, other.kind);
  if (first == DyadKind::crank) {
    switch (second) {
      case DyadKind::crank:
        return LinkageType::four_bar;
      case DyadKind::slider:
        return LinkageType::slider_crank;
      case DyadKind::inverted_slider:
        return LinkageType::inverted_slider_crank;
    }
  }
  if (second == DyadKind::slider) {
    return LinkageType::double_slider;
  }
  return first == DyadKind::slider ? LinkageType::slider_inverted_slider
                                   : LinkageType::double_inverted_slider;
}

const Dyad& input_of(const Linkage& linkage, Drive drive) {
  return drive == Drive::one ? linkage.one : linkage.other;
}

const Dyad& output_of(const Linkage& linkage, Drive drive) {
  return drive == Drive::one ? linkage.other : linkage.one;
}

Point Pose::place(const Point& moving) const {
  return origin + unit_vector(angle) * moving;
}

BoundedPoint Pose::bounded_place(const BoundedPoint& turn, const BoundedPoint& moving) const {
  return BoundedPoint::written(origin) + turn * moving;
}

Pose pose_of(const PositionJets& position) {
  return {.origin = origin(position), .angle = position.angle[0]};
}

Pose frame_of(DyadPoint which, std::span<const PositionJets> positions) {
  return which == DyadPoint::circle_point ? pose_of(positions[0]) : Pose{.origin = {0.0, 0.0}};
}

double FourBarLengths::longest() const {
  return std::ranges::max(as_array(*this));
}

double FourBarLengths::shortest() const {
  return std::ranges::min(as_array(*this));
}

std::optional<FourBarLengths> lengths_of(const Linkage& linkage) {
  if (linkage.type() != LinkageType::four_bar) {
    return std::nullopt;
  }
  const auto& [one, other] = linkage;
  const BoundedNumber ground = distance(centre_point_of(one), centre_point_of(other));
  const BoundedNumber coupler = distance(circle_point_of(one), circle_point_of(other));
  return FourBarLengths{
      .ground = ground.value,
      .crank_one = one.length,
      .coupler = coupler.value,
      .crank_other = other.length,
      .bound = ground.bound + coupler.bound + length_of(one).bound + length_of(other).bound};
}

std::string_view word_of(FourBarLink link) {
  switch (link) {
    case FourBarLink::ground:
      return "ground";
    case FourBarLink::crank_one:
      return "crank_one";
    case FourBarLink::coupler:
      return "coupler";
    case FourBarLink::crank_other:
      return "crank_other";
  }
  return "";
}

Grashof classify(const FourBarLengths& lengths) {
  const std::array<double, 4> all = as_array(lengths);
  const auto shortest = static_cast<FourBarLink>(std::ranges::min_element(all) - all.begin());
  const auto longest = static_cast<FourBarLink>(std::ranges::max_element(all) - all.begin());
  const double sum = all[0] + all[1] + all[2] + all[3];
  // s + l against p + q, of which the sum is the rest.
  const double excess = 2.0 * (lengths.shortest() + lengths.longest()) - sum;
  if (std::abs(excess) < std::max(kChangePoint * sum, lengths.bound)) {
    return {.kind = GrashofClass::change_point, .which = shortest};
  }
  if (excess > 0.0) {
    return {.kind = GrashofClass::triple_rocker, .which = longest};
  }
  switch (shortest) {
    case FourBarLink::ground:
      return {.kind = GrashofClass::double_crank, .which = shortest};
    case FourBarLink::coupler:
      return {.kind = GrashofClass::double_rocker, .which = shortest};
    case FourBarLink::crank_one:
    case FourBarLink::crank_other:
      break;
  }
  return {.kind = GrashofClass::crank_rocker, .which = shortest};
}

}  // namespace kinestat
