#include "studies/motion/peak_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/tolerance.hpp"

namespace kinestat {

namespace {

// Parabolas come nearer with the power 1.3 of what is off, three or four suffice for most tops, and
// golden sections by a third each. A fold is mostly nearer than a thousandth of what it was, or the
// trial tells that it lies on the other side.
constexpr int kMostTrials = 60;
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

constexpr std::size_t kMostPoints = 6;

// The polynomial through some samples: its powers about a share.
class Interpolant {
 public:
  Interpolant(std::span<const PeakSample> by, double about) {
    // By divided differences; then Newton's form is turned into powers by Horner's scheme.
    std::array<double, kMostPoints> differences{};
    for (std::size_t i = 0; i < by.size(); ++i) {
      differences[i] = by[i].value;
    }
    for (std::size_t order = 1; order < by.size(); ++order) {
      for (std::size_t i = by.size(); i-- > order;) {
        differences[i] =
            (differences[i] - differences[i - 1]) / (by[i].share - by[i - order].share);
      }
    }
    for (std::size_t i = by.size(); i-- > 0;) {
      for (std::size_t k = by.size() - 1; k > 0; --k) {
        powers_[k] = powers_[k] * (about - by[i].share) + powers_[k - 1];
      }
      powers_[0] = powers_[0] * (about - by[i].share) + differences[i];
    }
  }

  double slope() const { return powers_[1]; }

  // Of a cubic the way from there to where it is greatest, on the side to which it rises; empty
  // where it is so nowhere.
  std::optional<double> way_to_top() const {
    const double slope = std::abs(powers_[1]);
    const double bend = powers_[2];
    const double cube = std::copysign(powers_[3], powers_[3] * powers_[1]);
    const double root = bend * bend - 3.0 * cube * slope;
    const double divisor = -bend + std::sqrt(std::max(root, 0.0));
    return root > 0.0 && divisor > 0.0 ? std::optional(std::copysign(slope / divisor, powers_[1]))
                                       : std::nullopt;
  }

  double at(double way) const {
    double value = 0.0;
    for (std::size_t k = kMostPoints; k-- > 0;) {
      value = value * way + powers_[k];
    }
    return value;
  }

 private:
  std::array<double, kMostPoints> powers_{};
};

// Some of a run, those around the piece behind one of them.
std::span<const PeakSample> around(std::span<const PeakSample> run,
                                   std::size_t at,
                                   std::size_t count) {
  count = std::min(count, run.size());
  const std::size_t before = std::min(at, count / 2 - 1);
  return run.subspan(std::min(at - before, run.size() - count), count);
}

// Where the cubic is greatest inside the piece behind a sample; empty where it is so at an end.
std::optional<PeakSample> top_behind(std::span<const PeakSample> run, std::size_t at) {
  const Interpolant cubic(around(run, at, 4), run[at].share);
  const std::optional<double> way = cubic.way_to_top();
  return way && *way > 0.0 && *way < run[at + 1].share - run[at].share
             ? std::optional(PeakSample{.share = run[at].share + *way, .value = cubic.at(*way)})
             : std::nullopt;
}

// At an end of a run where it may rise inwards although the next sample is lower: a quarter of the
// piece inside, and how high it may be there.
std::optional<PeakSample> top_at_end(std::span<const PeakSample> run, bool is_first) {
  const PeakSample& end = is_first ? run.front() : run.back();
  const PeakSample& next = is_first ? run[1] : run[run.size() - 2];
  const auto slope = [&](std::size_t count) {
    const std::size_t most = std::min(count, run.size());
    return Interpolant(is_first ? run.first(most) : run.last(most), end.share).slope();
  };
  const double way = 0.25 * (next.share - end.share);
  const double best = slope(kMostPoints);
  const double rise =
      std::copysign(1.0, way) * best + 2.0 * std::abs(best - slope(kMostPoints - 2));
  return rise > 0.0 ? std::optional(PeakSample{.share = end.share + way,
                                               .value = end.value + rise * std::abs(way)})
                    : std::nullopt;
}

// Of what a climb promises beside a sample: twice of what a cubic says differs by.
double error_of(const PeakClimb& climb, std::span<const PeakSample> run, std::size_t at) {
  const std::optional<PeakSample>& promise = climb.promise();
  if (!promise) {
    return 0.0;
  }
  const std::size_t piece = promise->share < run[at].share ? at - 1 : at;
  const Interpolant cubic(around(run, piece, 4), run[piece].share);
  return 2.0 * std::abs(cubic.at(promise->share - run[piece].share) - promise->value);
}

}  // namespace

PeakClimb::PeakClimb(const PeakTriple& steps, const std::optional<double>& fold)
    : by_(steps), best_(steps[1]), height_(fold) {
  for (const PeakSample& one : steps) {
    best_ = is_more(one.value, best_.value) ? one : best_;
  }
  aim();
}

PeakClimb::PeakClimb(const PeakSample& before,
                     const PeakSample& promise,
                     const PeakSample& behind,
                     const std::optional<double>& fold)
    : by_{before, promise, behind},
      is_between_steps_(true),
      best_(is_more(behind.value, before.value) ? behind : before),
      promise_(promise),
      height_(fold) {}

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
  promise_.reset();
  const auto& [before, middle, behind] = by_;
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
    promise_ = way < kSameValue * width ? std::nullopt : vertex;
    return;
  }
  const bool is_among = middle.value >= before.value && middle.value >= behind.value;
  const double below = middle.value - std::min(before.value, behind.value);
  if (trials_ == 0 || height_ || !is_among || below <= kSameValue * std::abs(middle.value)) {
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

void PeakSearch::add_run(std::span<const PeakSample> run) {
  const auto is_top = [&](std::size_t i) {
    return i > 0 && i + 1 < run.size() && run[i - 1].value <= run[i].value &&
           run[i].value > run[i + 1].value;
  };
  for (std::size_t i = 0; i + 1 < run.size(); ++i) {
    if (is_top(i)) {
      const PeakClimb climb({run[i - 1], run[i], run[i + 1]}, fold_);
      add(climb, fold_ ? 0.0 : error_of(climb, run, i));
    }
    if (is_top(i) || is_top(i + 1) || run.size() < 3) {
      continue;
    }
    const bool is_at_end = i == 0 ? run[0].value > run[1].value
                                  : i + 2 == run.size() && run[i].value < run[i + 1].value;
    const auto top = is_at_end ? top_at_end(run, i == 0) : top_behind(run, i);
    if (top) {
      add(PeakClimb(run[i], *top, run[i + 1], fold_), 0.0);
    }
  }
}

void PeakSearch::add(const PeakClimb& climb, double error) {
  const std::optional<PeakSample>& promise = climb.promise();
  if (!promise || !is_more(promise->value + error, found_.value)) {
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
