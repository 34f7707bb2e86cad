#include "synthesis/linkage_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/contract.hpp"

namespace kinestat {

namespace {

constexpr double kPi = std::numbers::pi;

// The interval of the coordinate that a circuit fills, and whether its ends are dead points.
struct Interval {
  double low = 0.0;
  double high = 0.0;
  bool is_turn = false;  // a full turn
  bool low_dead = true;
  bool high_dead = true;
};

Interval interval_of_angle(const DriveCurve::Range& range, double x) {
  const bool upper_free = range.high >= 1.0;
  const bool lower_free = range.low <= -1.0;
  if (upper_free && lower_free) {
    return {.low = x, .high = x + 2.0 * kPi, .is_turn = true};
  }
  const double near = upper_free ? 0.0 : std::acos(std::clamp(range.high, -1.0, 1.0));
  const double far = lower_free ? kPi : std::acos(std::clamp(range.low, -1.0, 1.0));
  if (upper_free) {
    return {.low = -far, .high = far};
  }
  if (lower_free) {
    return {.low = near, .high = 2.0 * kPi - near};
  }
  return x < 0.0 ? Interval{.low = -far, .high = -near} : Interval{.low = near, .high = far};
}

Interval interval_of_square(const DriveCurve::Range& range, double x, double reach) {
  const double far = std::isfinite(range.high) ? std::sqrt(range.high) : reach;
  const bool far_dead = std::isfinite(range.high);
  if (range.low <= 0.0) {
    return {.low = -far, .high = far, .low_dead = far_dead, .high_dead = far_dead};
  }
  const double near = std::sqrt(range.low);
  return x < 0.0 ? Interval{.low = -far, .high = -near, .low_dead = far_dead}
                 : Interval{.low = near, .high = far, .high_dead = far_dead};
}

Interval interval_of(const DriveCurve& curve, double x, double reach) {
  const DriveCurve::Range range = curve.range();
  using enum DriveCurve::Argument;
  switch (curve.argument()) {
    case cosine:
      if (curve.is_open_ended()) {
        return x < 0.0 ? Interval{.low = -kPi, .high = 0.0, .low_dead = false, .high_dead = false}
                       : Interval{.low = 0.0, .high = kPi, .low_dead = false, .high_dead = false};
      }
      return interval_of_angle(range, x);
    case square:
      return interval_of_square(range, x, reach);
    case linear:
      return {.low = std::max(range.low, -reach),
              .high = std::min(range.high, reach),
              .low_dead = std::isfinite(range.low),
              .high_dead = std::isfinite(range.high)};
    case none:
      return {.low = x, .high = x + 2.0 * kPi, .is_turn = true};
  }
  return {};
}

}  // namespace

LinkageMotion trace_circuit(
    const Linkage& linkage, Drive drive, const Pose& start, int count, double reach) {
  KINESTAT_EXPECTS(count > 1);
  const DriveCurve curve(linkage, drive);
  const int side = curve.side_of(start);
  const Interval interval = interval_of(curve, curve.coordinate_of(start), reach);
  const bool goes_round = interval.low_dead && interval.high_dead && !interval.is_turn;
  LinkageMotion motion;
  motion.is_closed = interval.is_turn || goes_round;
  // A way that dead points bound is gone forth and back, slowly near them; another one evenly.
  for (int i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / (motion.is_closed ? count : count - 1);
    const double turn = 2.0 * kPi * share;
    const double middle = 0.5 * (interval.low + interval.high);
    const double half = 0.5 * (interval.high - interval.low);
    const double x =
        goes_round ? middle - half * std::cos(turn) : interval.low + 2.0 * half * share;
    const int now = goes_round && turn > kPi ? -side : side;
    if (const auto pose = curve.pose_at(x, now)) {
      motion.poses.push_back(*pose);
    }
  }
  return motion;
}

std::vector<Point> coupler_curve(const LinkageMotion& motion, const Point& moving) {
  std::vector<Point> path;
  path.reserve(motion.poses.size());
  for (const Pose& pose : motion.poses) {
    path.push_back(pose.place(moving));
  }
  return path;
}

}  // namespace kinestat
