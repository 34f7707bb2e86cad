#include "studies/motion/peak_search.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"

namespace kinestat {

namespace {

// Parabolas come nearer with the power 1.3 of what is off, three or four suffice for most tops. A
// fold is mostly nearer than a thousandth of what it was, or the trial tells that it lies on the
// other side.
constexpr int kMostTrials = 10;
constexpr int kMostFoldTrials = 12;

// A trial that comes nearer to a fold comes at least so much nearer.
constexpr double kNearerShare = 0.25;

// By more than rounding, which must not decide between what is equal.
bool is_more(double value, double than) {
  return value - than > kSameValue * std::max(std::abs(value), std::abs(than));
}

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
    best_ = is_more(one.value, best_.value) ? one : best_;
  }
  aim();
}

void PeakClimb::aim() {
  if (height_) {
    aim_at_fold();
  }
  if (!fold_) {
    aim_at_vertex();
  }
}

void PeakClimb::aim_at_vertex() {
  promise_ = vertex_trials_ < kMostTrials ? Parabola(by_).vertex() : std::nullopt;
  const double width = by_[2].share - by_[0].share;
  const bool is_inside =
      promise_ && promise_->share > by_[0].share && promise_->share < by_[2].share;
  if (!is_inside || std::abs(promise_->share - by_[1].share) < kSameValue * width) {
    promise_.reset();
  }
  ++vertex_trials_;
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
    if (is_more(least, std::abs(parabola.bend)) && is_between && trials_ < kMostFoldTrials) {
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
  const bool is_as_promised = std::abs(value - promise_->value) <= kSameValue * std::abs(value);
  ++trials_;
  promise_.reset();
  narrow(next);
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
  if (next.value > by_[1].value) {
    by_ = is_behind ? PeakTriple{by_[1], next, by_[2]} : PeakTriple{by_[0], next, by_[1]};
  } else {
    by_ = is_behind ? PeakTriple{by_[0], by_[1], next} : PeakTriple{next, by_[1], by_[2]};
  }
}

void PeakSearch::add(const PeakTriple& steps) {
  const PeakClimb climb(steps, fold_);
  const std::optional<PeakSample>& promise = climb.promise();
  if (!promise || !is_more(promise->value, found_.value)) {
    return;
  }
  std::size_t at = count_;
  while (at > 0 && is_more(promise->value, climbs_[at - 1].promise()->value)) {
    --at;
  }
  if (at == kMostClimbs) {
    return;
  }
  count_ = std::min(count_ + 1, kMostClimbs);
  for (std::size_t i = count_ - 1; i > at; --i) {
    climbs_[i] = climbs_[i - 1];
  }
  climbs_[at] = climb;
}

std::optional<double> PeakSearch::next() {
  while (now_ < count_ && !(fold_ && !is_more(*fold_, found_.value))) {
    if (const std::optional<PeakSample>& promise = climbs_[now_].promise()) {
      return promise->share;
    }
    end_climb();
  }
  return std::nullopt;
}

void PeakSearch::take(const std::optional<double>& value) {
  if (value) {
    climbs_[now_].take(*value);
  } else {
    end_climb();
  }
}

void PeakSearch::end_climb() {
  const PeakSample& best = climbs_[now_++].best();
  if (is_more(best.value, found_.value)) {
    found_ = best;
    is_better_ = true;
  }
}

}  // namespace kinestat
