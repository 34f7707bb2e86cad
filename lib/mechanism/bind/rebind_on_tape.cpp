// What a Rebinder does, on a tape.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/tolerance.hpp"
#include "mechanism/bind/rebind.hpp"

namespace kinestat {

namespace {

using TapedPoint = std::array<TapeNumber, 3>;

TapedScrew constant_screw(const Vec6& coordinates, LaneRecorder& recorder) {
  TapedScrew screw;
  for (std::size_t i = 0; i < screw.size(); ++i) {
    screw[i] = recorder.constant(coordinates[static_cast<Eigen::Index>(i)]);
  }
  return screw;
}

// As moment_of_line, of a line of fixed direction.
TapedPoint moment_of(const TapedPoint& point, const Vec3& direction, LaneRecorder& recorder) {
  TapedPoint moment;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const auto along = [&](std::size_t axis) {
      return recorder.constant(direction[static_cast<Eigen::Index>(axis)]);
    };
    moment[i] =
        recorder.subtract_product(recorder.multiply(point[j], along(k)), point[k], along(j));
  }
  return moment;
}

// That the screws may stay about the world origin, as find_extent decides: |centre| ≤ limit ·
// |box|. A lane at the very limit has no answer.
void demand_near_origin(const std::vector<TapedPoint>& points, LaneRecorder& recorder) {
  if (points.empty()) {
    return;
  }
  constexpr double kLimit = kFarOrigin * kFarOrigin * (1.0 - kCancellation);
  TapeNumber centre = recorder.constant(0.0);
  TapeNumber box = centre;
  for (std::size_t i = 0; i < 3; ++i) {
    TapeNumber low = points.front()[i];
    TapeNumber high = low;
    for (const TapedPoint& point : points) {
      low = recorder.smaller(low, point[i]);
      high = recorder.larger(high, point[i]);
    }
    const TapeNumber middle = recorder.multiply(recorder.add(low, high), recorder.constant(0.5));
    const TapeNumber length = recorder.subtract(high, low);
    centre = recorder.add(centre, recorder.multiply(middle, middle));
    box = recorder.add(box, recorder.multiply(length, length));
  }
  recorder.demand_at_most(centre, recorder.multiply(box, recorder.constant(kLimit)));
  // What is smaller is too small to be computed with, or has no size.
  recorder.demand_at_most(recorder.constant(1.0 / (kLargestNumber * kLargestNumber)), box);
}

// With all coordinates up to the limit the centre of the box is no farther than √3 of it, while the
// diagonal is that of the fixed points at least. False where these are too close for that.
bool demand_near_fixed(const std::vector<TapedPoint>& points, LaneRecorder& recorder) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::max());
  Vec3 high = -low;
  for (const TapedPoint& point : points) {
    if (std::ranges::all_of(point, [&](TapeNumber x) { return recorder.is_constant(x); })) {
      const Vec3 at(recorder.value(point[0]), recorder.value(point[1]), recorder.value(point[2]));
      low = low.cwiseMin(at);
      high = high.cwiseMax(at);
    }
  }
  const double limit =
      (low.array() <= high.array()).all() ? kFarOrigin / 2 * (high - low).norm() : 0.0;
  for (const TapedPoint& point : points) {
    for (const TapeNumber coordinate : point) {
      if (!(std::abs(recorder.value(coordinate)) <= limit)) {
        return false;
      }
      recorder.demand_at_most(coordinate, recorder.constant(limit));
    }
  }
  return true;
}

// A rule of teeth on a tape.
struct TapedRule {
  const ToothRule& rule;
  const Mechanism& mechanism;
  TapedPoint point;
  const TapedScrews& screws;
};

// How far the axis of a wheel is from the teeth, along `normal`: v · (n x a). Empty of what does
// not turn about the axis of rolling, and of a wheel that is not known.
std::optional<TapeNumber> arm_on_tape(const TapedRule& teeth,
                                      int freedom,
                                      const Vec3& normal,
                                      LaneRecorder& recorder) {
  const Topology& topology = teeth.mechanism.topology;
  const std::vector<Twist>& motions = teeth.mechanism.geometry.motions;
  const auto rolls = static_cast<std::size_t>(topology.coupling(teeth.rule.coupling).first_freedom);
  if (freedom < 0) {
    return std::nullopt;
  }
  const auto f = static_cast<std::size_t>(freedom);
  const Vec3& axis = motions[f].angular;
  if (axis.isZero(0.0) || axis.cross(motions[rolls].angular).norm() > kParallelAxes) {
    return std::nullopt;
  }
  const TapedPoint turned = moment_of(teeth.point, axis, recorder);
  const Vec3 along = normal.cross(axis);
  TapeNumber arm = recorder.constant(0.0);
  for (std::size_t i = 0; i < 3; ++i) {
    const TapeNumber velocity = recorder.subtract(teeth.screws.motions[f][3 + i], turned[i]);
    const double part = along[static_cast<Eigen::Index>(i)];
    arm = recorder.add(arm, recorder.multiply(velocity, recorder.constant(part)));
  }
  return arm;
}

// That the flank which pushes stays the same: both axes stay on their sides of the teeth, and of
// two on one side the nearer one is the same.
bool demand_sides(const TapedRule& teeth, LaneRecorder& recorder) {
  const Mechanism& mechanism = teeth.mechanism;
  const Vec3 normal =
      pitch_normal<double>(teeth.rule, mechanism.topology, mechanism.geometry).normalized();
  const auto tail = arm_on_tape(teeth, teeth.rule.tail, normal, recorder);
  const auto head = arm_on_tape(teeth, teeth.rule.head, normal, recorder);
  if (!tail || !head) {
    return false;
  }
  const TapeNumber zero = recorder.constant(0.0);
  const auto demand_positive = [&](TapeNumber number) {
    recorder.demand_at_most(recorder.smaller(number, zero), zero);
  };
  const auto size_of = [&](TapeNumber arm) {
    return recorder.value(arm) < 0.0 ? recorder.subtract(zero, arm) : arm;
  };
  const TapeNumber of_tail = size_of(*tail);
  const TapeNumber of_head = size_of(*head);
  demand_positive(of_tail);
  demand_positive(of_head);
  if (recorder.value(*tail) * recorder.value(*head) > 0.0) {
    const bool is_head_nearer = recorder.value(of_head) <= recorder.value(of_tail);
    demand_positive(is_head_nearer ? recorder.subtract(of_tail, of_head)
                                   : recorder.subtract(of_head, of_tail));
  }
  return true;
}

}  // namespace

bool Rebinder::record_points(std::span<const std::optional<TapeQuantity>> slots,
                             std::vector<TapedPoint>& points,
                             LaneRecorder& recorder) const {
  constexpr double kLargestCoordinate = 1e100;  // [m] its square is a number
  for (const Vec3& point : points_) {
    points.push_back(
        {recorder.constant(point.x()), recorder.constant(point.y()), recorder.constant(point.z())});
  }
  for (const MovingCoupling& moving : moving_) {
    for (std::size_t i = 0; i < moving.at.size(); ++i) {
      if (!moving.at[i].formula) {
        continue;
      }
      const std::optional<TapeNumber> coordinate = record_as(
          QuantityKind::length, *moving.at[i].formula, description_->units, slots, recorder);
      if (!coordinate) {
        return false;
      }
      recorder.demand_at_most(*coordinate, recorder.constant(kLargestCoordinate));
      points[*moving.point][i] = *coordinate;
    }
  }
  return true;
}

std::optional<TapedScrews> Rebinder::record_screws(
    NearOrigin near,
    const Geometry& geometry,
    std::span<const std::optional<TapeQuantity>> slots,
    LaneRecorder& recorder) const {
  const auto is_simple = [](const MovingCoupling& moving) {
    return moving.is_through_point && !moving.is_in_gears;
  };
  std::vector<TapedPoint> points;
  if (!std::ranges::all_of(moving_, is_simple) || !record_points(slots, points, recorder)) {
    return std::nullopt;
  }
  if (near == NearOrigin::by_all_points) {
    demand_near_origin(points, recorder);
  } else if (!demand_near_fixed(points, recorder)) {
    return std::nullopt;
  }
  TapedScrews screws;
  for (const Twist& twist : geometry.motions) {
    screws.motions.push_back(constant_screw(twist.coordinates(), recorder));
  }
  for (const Wrench& wrench : geometry.actions) {
    screws.actions.push_back(constant_screw(wrench.coordinates(), recorder));
  }
  for (const OtherFlankOf<double>& flank : geometry.other_flanks) {
    screws.flanks.push_back(constant_screw(flank.screw.coordinates(), recorder));
  }
  for (const MovingCoupling& moving : moving_) {
    const CouplingTopology& one =
        mechanism_->topology.couplings[static_cast<std::size_t>(moving.coupling)];
    const TapedPoint& point = points[*moving.point];
    for (int f = one.first_freedom; f < one.first_freedom + one.freedom_count; ++f) {
      const Vec3& axis = geometry.motions[static_cast<std::size_t>(f)].angular;
      if (!axis.isZero(0.0)) {
        std::ranges::copy(moment_of(point, axis, recorder),
                          screws.motions[static_cast<std::size_t>(f)].begin() + 3);
      }
    }
    for (int a = one.first_action; a < one.first_action + one.action_count; ++a) {
      const Vec3& line = geometry.actions[static_cast<std::size_t>(a)].force;
      if (!line.isZero(0.0)) {
        std::ranges::copy(moment_of(point, line, recorder),
                          screws.actions[static_cast<std::size_t>(a)].begin());
      }
    }
    if (moving.flank >= 0) {
      const auto f = static_cast<std::size_t>(moving.flank);
      std::ranges::copy(moment_of(point, geometry.other_flanks[f].screw.force, recorder),
                        screws.flanks[f].begin());
    }
  }
  const auto point_of = [&](CouplingId id) {
    const auto moving = std::ranges::find(moving_, id.value, &MovingCoupling::coupling);
    if (moving != moving_.end()) {
      return points[*moving->point];
    }
    TapedPoint point;
    std::ranges::transform(geometry.points[static_cast<std::size_t>(id.value)],
                           point.begin(),
                           [&](double x) { return recorder.constant(x); });
    return point;
  };
  const bool keep_sides = std::ranges::all_of(mechanism_->tooth_rules, [&](const ToothRule& rule) {
    return !moves(rule) || demand_sides({.rule = rule,
                                         .mechanism = *mechanism_,
                                         .point = point_of(rule.coupling),
                                         .screws = screws},
                                        recorder);
  });
  return keep_sides ? std::optional(std::move(screws)) : std::nullopt;
}

TapedPrimaries Rebinder::record_primaries(std::size_t index,
                                          const Case& which,
                                          std::span<const std::optional<TapeQuantity>> slots,
                                          LaneRecorder& recorder) const {
  TapedPrimaries result;
  for (const Primary& primary : which.motions) {
    result.motions.push_back(recorder.constant(primary.value));
  }
  for (const Primary& primary : which.actions) {
    result.actions.push_back(recorder.constant(primary.value));
  }
  for (const MovingPrimary& one : primaries_) {
    if (one.which == index) {
      (one.is_motion ? result.motions : result.actions)[one.primary] =
          record_as(one.kind, one.value, description_->units, slots, recorder);
    }
  }
  return result;
}

}  // namespace kinestat
