#include "studies/synthesis/linkages/linkage_motion.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <queue>

#include "core/contract.hpp"

namespace kinestat {

namespace {

// The interval of the coordinate that a circuit fills, and whether its ends are dead points.
struct Interval {
  double low = 0.0;
  double high = 0.0;
  bool is_turn = false;  // a full turn
  bool low_dead = true;
  bool high_dead = true;
};

Interval interval_of_angle(const DriveCurve::Range& range, double x) {
  const bool is_free_at_zero = range.low <= 0.0;
  const bool is_free_at_pi = range.high >= std::numbers::pi;
  if (is_free_at_zero && is_free_at_pi) {
    return {.low = x, .high = x + 2.0 * std::numbers::pi, .is_turn = true};
  }
  if (is_free_at_zero) {
    return {.low = -range.high, .high = range.high};
  }
  if (is_free_at_pi) {
    return {.low = range.low, .high = 2.0 * std::numbers::pi - range.low};
  }
  return x < 0.0 ? Interval{.low = -range.high, .high = -range.low}
                 : Interval{.low = range.low, .high = range.high};
}

Interval interval_of_square(const DriveCurve::Range& range, double x, double reach) {
  const bool far_dead = std::isfinite(range.high);
  const double far = far_dead ? range.high : reach;
  if (range.low <= 0.0) {
    return {.low = -far, .high = far, .low_dead = far_dead, .high_dead = far_dead};
  }
  return x < 0.0 ? Interval{.low = -far, .high = -range.low, .low_dead = far_dead}
                 : Interval{.low = range.low, .high = far, .high_dead = far_dead};
}

Interval interval_of(const DriveCurve& curve, double x, double reach) {
  const DriveCurve::Range range = curve.range();
  using enum DriveCurve::Argument;
  switch (curve.argument()) {
    case cosine:
      if (curve.is_open_ended()) {
        return x < 0.0 ? Interval{.low = -std::numbers::pi,
                                  .high = 0.0,
                                  .low_dead = false,
                                  .high_dead = false}
                       : Interval{.low = 0.0,
                                  .high = std::numbers::pi,
                                  .low_dead = false,
                                  .high_dead = false};
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
      return {.low = x, .high = x + 2.0 * std::numbers::pi, .is_turn = true};
  }
  return {};
}

// Dead points lead from one side to the other: through both of them round, through one of them to
// it and back; without any the side stays.
enum class Course { along, back_from_low, back_from_high, round };

Course course_of(const Interval& interval) {
  if (interval.is_turn || (!interval.low_dead && !interval.high_dead)) {
    return Course::along;
  }
  if (interval.low_dead && interval.high_dead) {
    return Course::round;
  }
  return interval.low_dead ? Course::back_from_low : Course::back_from_high;
}

struct Place {
  double x = 0.0;
  bool is_other_side = false;
};

// The place at a share of the way, which slows down at dead points.
Place place_on(const Interval& interval, Course course, double share) {
  const double middle = 0.5 * (interval.low + interval.high);
  const double half = 0.5 * (interval.high - interval.low);
  const double way = 2.0 * share - 1.0;  // -1 to 1
  switch (course) {
    case Course::along:
      return {.x = middle + half * way};
    case Course::round:
      return {.x = middle + half * std::cos(std::numbers::pi * way), .is_other_side = way > 0.0};
    case Course::back_from_low:
      return {.x = interval.low + 2.0 * half * way * way, .is_other_side = way > 0.0};
    case Course::back_from_high:
      return {.x = interval.high - 2.0 * half * way * way, .is_other_side = way > 0.0};
  }
  return {};
}

// Steps of equal shares of the way; then the longest step is halved again and again, so that the
// poses are about equally far from each other even where the input hardly moves.
class Tracer {
 public:
  Tracer(const Linkage& linkage, Drive drive, const Pose& start, double reach)
      : curve_(linkage, drive),
        start_(start),
        reach_(reach),
        lever_(std::abs(linkage.one.circle_point) + std::abs(linkage.other.circle_point)),
        side_(curve_.transmission_of(start).side < 0 ? -1 : 1),
        interval_(interval_of(curve_, curve_.coordinate_of(start), reach)),
        course_(course_of(interval_)) {}

  LinkageMotion run(std::size_t count) {
    LinkageMotion motion;
    motion.is_closed = interval_.is_turn || course_ == Course::round;
    const std::size_t first = count / 2 + 1;
    const std::size_t steps = motion.is_closed ? first : first - 1;
    for (std::size_t i = 0; i <= steps; ++i) {
      add(static_cast<double>(i) / static_cast<double>(steps));
    }
    for (std::size_t i = 0; i < steps; ++i) {
      push(i, i + 1);
    }
    // The end of a closed way is its beginning.
    while (samples_.size() < (motion.is_closed ? count + 1 : count) && !steps_.empty()) {
      halve();
    }
    std::ranges::sort(samples_, {}, &Sample::share);
    samples_.resize(samples_.size() - (motion.is_closed ? 1 : 0));
    for (const Sample& sample : samples_) {
      if (sample.pose) {
        motion.poses.push_back(*sample.pose);
      }
    }
    return motion;
  }

 private:
  struct Sample {
    double share = 0.0;
    std::optional<Pose> pose;
  };

  struct Step {
    double length = 0.0;
    std::size_t from = 0;
    std::size_t to = 0;

    bool operator<(const Step& other) const {
      return length != other.length ? length < other.length : from > other.from;
    }
  };

  void add(double share) {
    const auto [x, is_other_side] = place_on(interval_, course_, share);
    samples_.push_back({.share = share, .pose = curve_.pose_at(x, is_other_side ? -side_ : side_)});
  }

  bool is_beyond(const Pose& pose) const { return std::abs(pose.origin - start_.origin) > reach_; }

  // What lies beyond the reach at both ends does not count.
  double length_of(const Sample& one, const Sample& other) const {
    if (!one.pose || !other.pose || (is_beyond(*one.pose) && is_beyond(*other.pose))) {
      return 0.0;
    }
    const double turn = std::abs(unit_vector(one.pose->angle) - unit_vector(other.pose->angle));
    return std::abs(one.pose->origin - other.pose->origin) + lever_ * turn;
  }

  void push(std::size_t from, std::size_t to) {
    steps_.push({.length = length_of(samples_[from], samples_[to]), .from = from, .to = to});
  }

  void halve() {
    const Step longest = steps_.top();
    steps_.pop();
    add(0.5 * (samples_[longest.from].share + samples_[longest.to].share));
    push(longest.from, samples_.size() - 1);
    push(samples_.size() - 1, longest.to);
  }

  DriveCurve curve_;
  Pose start_;
  double reach_;
  double lever_;  // of the turn of the plane
  int side_;
  Interval interval_;
  Course course_;
  std::vector<Sample> samples_;
  std::priority_queue<Step> steps_;
};

}  // namespace

LinkageMotion trace_circuit(
    const Linkage& linkage, Drive drive, const Pose& start, int count, double reach) {
  KINESTAT_EXPECTS(count > 1);
  return Tracer(linkage, drive, start, reach).run(static_cast<std::size_t>(count));
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
