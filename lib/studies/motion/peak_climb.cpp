#include "studies/motion/peak_climb.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/tolerance.hpp"

namespace kinestat {

bool is_higher(double value, double than) {
  return value - than > kSameValue * std::max(std::abs(value), std::abs(than));
}

namespace {

// Parabolas come nearer with the power 1.3 of what is off, three or four suffice for most tops, and
// golden sections by a third each. A fold is mostly nearer than a thousandth of what it was, or the
// trial tells that it lies on the other side.
constexpr int kMostTrials = 60;
constexpr int kMostFoldTrials = 12;

// A trial that comes nearer to a fold comes at least so much nearer.
constexpr double kNearerShare = 0.25;

// From the middle one of three samples.
struct Parabola {
  PeakSample middle;
  double slope = 0.0;
  double bend = 0.0;

  explicit Parabola(const PeakTriple& by) : middle(by[1]) {
    const double low = by[0].share - by[1].share;
    const double high = by[2].share - by[1].share;
    const double low_slope = (by[0].value - by[1].value) / low;
    const double high_slope = (by[2].value - by[1].value) / high;
    bend = (high_slope - low_slope) / (high - low);
    slope = low_slope - bend * low;
  }

  // Where it is greatest; empty where it opens upwards, or is a line to rounding.
  std::optional<PeakSample> vertex() const {
    if (!(bend < 0.0)) {
      return std::nullopt;
    }
    const double way = -slope / (2.0 * bend);
    return PeakSample{.share = middle.share + way,
                      .value = middle.value + way * (slope + bend * way)};
  }

  // The way from the middle to where it is zero, on the side on which it is beyond zero.
  double way_to_zero(double side) const {
    const double root = std::sqrt(std::max(0.0, slope * slope - 4.0 * bend * middle.value));
    const double sum = -0.5 * (slope + std::copysign(root, slope));
    const double one = middle.value / sum;
    const double other = sum / bend;
    const bool is_other = one * side < 0.0 || (other * side >= 0.0 && other * side < one * side);
    return is_other ? other : one;
  }
};

}  // namespace

PeakClimb::PeakClimb(const PeakTriple& steps, const std::optional<double>& fold)
    : by_(steps), best_(steps[1]), height_(fold) {
  for (const PeakSample& one : steps) {
    best_ = is_higher(one.value, best_.value) ? one : best_;
    extent_ = std::max(extent_, std::abs(one.value - steps[1].value));
  }
  aim();
}

PeakClimb::PeakClimb(const PeakSample& before,
                     const PeakSample& promise,
                     const PeakSample& behind,
                     const std::optional<double>& fold)
    : by_{before, promise, behind},
      is_between_steps_(true),
      best_(is_higher(behind.value, before.value) ? behind : before),
      promise_(promise),
      height_(fold),
      extent_(std::abs(behind.value - before.value)) {}

void PeakClimb::aim() {
  if (height_) {
    aim_at_fold();
  }
  if (!fold_) {
    aim_at_vertex();
  }
}

// A parabola whose vertex is as far as where it was looked for two trials ago comes no nearer.
void PeakClimb::aim_at_vertex() {
  constexpr double kGolden = 0.3819660112501051;
  constexpr double kFar = 0.01;
  promise_.reset();
  const PeakSample& before = by_[0];
  const PeakSample& middle = by_[1];
  const PeakSample& behind = by_[2];
  const double width = behind.share - before.share;
  if (trials_ >= (height_ ? kMostFoldTrials : kMostTrials) || !(width > 0.0)) {
    return;
  }
  const auto is_inside = [&](const PeakSample& one) {
    return one.share > before.share && one.share < behind.share;
  };
  const std::optional<PeakSample> vertex = Parabola(by_).vertex();
  const double way = vertex ? std::abs(vertex->share - middle.share) : 0.0;
  if (vertex && is_inside(*vertex) && (way_before_ == 0.0 || way < 0.5 * way_before_)) {
    if (way >= kSameValue * width) {
      promise_ = vertex;
    } else if (trials_ == 0 || last_way_ > kFar * width) {
      // Two of one height beside a top may be so by chance: a look aside tells.
      promise_ = {.share = std::lerp(middle.share, behind.share, kGolden), .value = middle.value};
    }
    return;
  }
  const bool is_among = middle.value >= before.value && middle.value >= behind.value;
  const double below = middle.value - std::min(before.value, behind.value);
  if (trials_ == 0 || height_ || !is_among ||
      below <= kSameValue * std::max(std::abs(middle.value), extent_)) {
    return;
  }
  const std::optional<PeakSample> meeting = has_tried_corner_ ? std::nullopt : corner();
  if (meeting && is_inside(*meeting) &&
      std::abs(meeting->share - middle.share) > kSameValue * width) {
    has_tried_corner_ = true;
    promise_ = meeting;
    return;
  }
  has_tried_corner_ = false;
  const bool is_before = middle.share - before.share > behind.share - middle.share;
  promise_ = {.share = std::lerp(middle.share, (is_before ? before : behind).share, kGolden),
              .value = std::numeric_limits<double>::quiet_NaN()};
}

// Where the lines on both sides meet, as at a kink.
std::optional<PeakSample> PeakClimb::corner() const {
  if (!outer_[0] || !outer_[1]) {
    return std::nullopt;
  }
  const auto slope = [](const PeakSample& one, const PeakSample& other) {
    return (other.value - one.value) / (other.share - one.share);
  };
  const double rise = slope(*outer_[0], by_[0]);
  const double fall = slope(by_[2], *outer_[1]);
  const double share =
      (by_[2].value - by_[0].value + rise * by_[0].share - fall * by_[2].share) / (rise - fall);
  return PeakSample{.share = share, .value = by_[0].value + rise * (share - by_[0].share)};
}

// Unfolded, as what is missing up to the fold and then beyond it, the value bends least.
void PeakClimb::aim_at_fold() {
  PeakTriple missing = by_;
  for (PeakSample& one : missing) {
    one.value = *height_ - one.value;
  }
  double least = std::abs(Parabola(missing).bend);
  fold_.reset();
  for (const double side : {1.0, -1.0}) {
    PeakTriple unfolded = missing;
    PeakSample& beyond = side > 0.0 ? unfolded[2] : unfolded[0];
    beyond.value = -beyond.value;
    const Parabola parabola(unfolded);
    const double way = parabola.way_to_zero(side);
    const bool is_between = way != 0.0 && std::abs(way) < std::abs(beyond.share - by_[1].share);
    if (is_higher(least, std::abs(parabola.bend)) && is_between && trials_ < kMostFoldTrials) {
      least = std::abs(parabola.bend);
      promise_ = {.share = by_[1].share + way, .value = *height_};
      fold_ = {.below = *height_ - best_.value,
               .slope = std::abs(parabola.slope + 2.0 * parabola.bend * way),
               .side = side,
               .is_from_best = false,
               .has_tried_both = false};
    }
  }
}

void PeakClimb::take(double value) {
  const PeakSample next = {.share = promise_->share, .value = value};
  const bool is_as_promised =
      std::abs(value - promise_->value) <= kSameValue * std::max(std::abs(value), extent_);
  ++trials_;
  promise_.reset();
  way_before_ = last_way_;
  last_way_ = std::abs(next.share - by_[1].share);
  if (is_between_steps_) {
    by_[1] = next;
    is_between_steps_ = false;
    last_way_ = 0.0;
  } else {
    narrow(next);
  }
  const PeakSample before = best_;
  best_ = value > best_.value ? next : best_;
  if (!is_as_promised && fold_) {
    approach_fold(before, next);
  } else if (!is_as_promised) {
    aim();
  }
}

// On which side of a position the fold lies only another one tells.
void PeakClimb::approach_fold(const PeakSample& before, const PeakSample& next) {
  Fold& fold = *fold_;
  const double below = *height_ - next.value;
  if (below < kNearerShare * fold.below) {
    fold.below = below;
    fold.has_tried_both = false;
  } else if (fold.is_from_best && !fold.has_tried_both && next.value <= before.value) {
    fold.slope = std::abs((below - fold.below) / (next.share - before.share));
    fold.side = -fold.side;
    fold.has_tried_both = true;
  } else {
    aim();
    return;
  }
  fold.is_from_best = true;
  const double share = best_.share + fold.side * fold.below / fold.slope;
  if (trials_ < kMostFoldTrials && share > by_[0].share && share < by_[2].share) {
    promise_ = {.share = share, .value = *height_};
  }
}

// Keeps three samples of which the one in the middle is the greatest, where that can be.
void PeakClimb::narrow(const PeakSample& next) {
  const bool is_behind = next.share > by_[1].share;
  const bool is_greater = next.value > by_[1].value;
  const std::size_t side = is_behind == is_greater ? 0 : 1;  // which is left behind
  outer_[side] = by_[2 * side];
  if (is_greater) {
    by_ = is_behind ? PeakTriple{by_[1], next, by_[2]} : PeakTriple{by_[0], next, by_[1]};
  } else {
    by_ = is_behind ? PeakTriple{by_[0], by_[1], next} : PeakTriple{next, by_[1], by_[2]};
  }
}

}  // namespace kinestat
