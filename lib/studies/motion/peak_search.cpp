#include "studies/motion/peak_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace kinestat {

namespace {

constexpr std::size_t kMostPoints = PeakSearch::kMostPoints;

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

  // Of a cubic that rises there the way ahead to where it is greatest; empty of others.
  std::optional<double> way_to_top() const {
    const double slope = powers_[1];
    const double bend = powers_[2];
    const double root = bend * bend - 3.0 * powers_[3] * slope;
    const double divisor = -bend + std::sqrt(std::max(root, 0.0));
    return slope > 0.0 && root > 0.0 && divisor > 0.0 ? std::optional(slope / divisor)
                                                      : std::nullopt;
  }

  // Of a parabola, where it opens downwards.
  std::optional<double> way_to_vertex() const {
    return powers_[2] < 0.0 ? std::optional(-0.5 * powers_[1] / powers_[2]) : std::nullopt;
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
  return way && *way < run[at + 1].share - run[at].share
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
  const PeakSample& third = is_first ? run[2] : run[run.size() - 3];
  const double bend = end.value - 2.0 * next.value + third.value;
  const double most = end.value + 0.5 * std::abs(end.value - next.value) + 0.125 * std::abs(bend);
  return rise > 0.0
             ? std::optional(PeakSample{.share = end.share + way,
                                        .value = std::min(end.value + rise * std::abs(way), most)})
             : std::nullopt;
}

// How high lines through two samples on either side of a piece meet within it, as at a kink.
double kink_between(std::span<const PeakSample> run, std::size_t before, std::size_t behind) {
  if (before < 1 || behind + 1 >= run.size()) {
    return -std::numeric_limits<double>::infinity();
  }
  const PeakSample& low = run[before];
  const PeakSample& high = run[behind];
  const double rise = (low.value - run[before - 1].value) / (low.share - run[before - 1].share);
  const double fall = (run[behind + 1].value - high.value) / (run[behind + 1].share - high.share);
  const double way = (high.value - low.value - fall * (high.share - low.share)) / (rise - fall);
  return way > 0.0 && way < high.share - low.share ? low.value + rise * way
                                                   : -std::numeric_limits<double>::infinity();
}

// The same of the pieces beside a sample, and of both together.
double kink_above(std::span<const PeakSample> run, std::size_t at) {
  return std::max({kink_between(run, at - 1, at + 1),
                   kink_between(run, at - 1, at),
                   kink_between(run, at, at + 1)});
}

// How high the polynomial through all comes in the pieces beside a sample.
double bent_above(std::span<const PeakSample> run, std::size_t at) {
  constexpr int kLooks = 4;  // a piece
  const Interpolant all(run, run[at].share);
  double most = run[at].value;
  for (int i = 1; i < kLooks; ++i) {
    const double part = static_cast<double>(i) / kLooks;
    most = std::max({most,
                     all.at(part * (run[at - 1].share - run[at].share)),
                     all.at(part * (run[at + 1].share - run[at].share))});
  }
  return most;
}

// How high a climb beside a sample may come: twice as far above what it promises as cubics and
// others say that it may, or to a kink.
double most_of(const PeakClimb& climb, std::span<const PeakSample> run, std::size_t at) {
  const std::optional<PeakSample>& promise = climb.promise();
  if (!promise) {
    return run[at].value;
  }
  const std::size_t piece = promise->share < run[at].share ? at - 1 : at;
  const Interpolant cubic(around(run, piece, 4), run[piece].share);
  const double bent =
      std::max(std::abs(cubic.at(promise->share - run[piece].share) - promise->value),
               bent_above(run, at) - promise->value);
  return std::max(promise->value + 2.0 * bent, kink_above(run, at));
}

// Of sizes below zero, where the parabola through the squares of three is greatest between them.
std::optional<PeakSample> top_of_squares(const PeakSample& a,
                                         const PeakSample& b,
                                         const PeakSample& c) {
  const std::array squares = {PeakSample{.share = a.share, .value = -a.value * a.value},
                              PeakSample{.share = b.share, .value = -b.value * b.value},
                              PeakSample{.share = c.share, .value = -c.value * c.value}};
  const Interpolant parabola(squares, b.share);
  const std::optional<double> way = parabola.way_to_vertex();
  if (!way || *way <= a.share - b.share || *way >= c.share - b.share) {
    return std::nullopt;
  }
  return PeakSample{.share = b.share + *way,
                    .value = -std::sqrt(std::max(0.0, -parabola.at(*way)))};
}

}  // namespace

void PeakSearch::add_top(const Window& by) {
  const PeakSample& before = by.steps[by.at - 1];
  const PeakSample& top = by.steps[by.at];
  const PeakSample& behind = by.steps[by.at + 1];
  const PeakClimb climb({before, top, behind}, fold_);
  if (!climb.promise()) {
    return;
  }
  double most = fold_ ? climb.promise()->value : most_of(climb, by.span(), by.at);
  if (is_size_) {
    const auto squared = top_of_squares(before, top, behind);
    most = std::max(most, squared ? squared->value : most);
  }
  add({.climb = climb, .most = most});
}

void PeakSearch::add_behind(const Window& by) {
  if (const auto top = top_behind(by.span(), by.at)) {
    add({.climb = PeakClimb(by.steps[by.at], *top, by.steps[by.at + 1], fold_),
         .most = top->value});
  }
}

void PeakSearch::add_at_end(const Window& by) {
  const std::size_t piece = by.at == 0 ? 0 : by.at - 1;
  std::optional<PeakSample> top = top_at_end(by.span(), by.at == 0);
  if (is_size_) {
    const std::size_t middle = by.at == 0 ? 1 : by.at - 1;
    const auto squared =
        top_of_squares(by.steps[middle - 1], by.steps[middle], by.steps[middle + 1]);
    const bool is_inside = squared && squared->share > by.steps[piece].share &&
                           squared->share < by.steps[piece + 1].share;
    top = is_inside && (!top || is_higher(squared->value, top->value)) ? squared : top;
  }
  if (top) {
    add({.climb = PeakClimb(by.steps[piece], *top, by.steps[piece + 1], fold_),
         .most = top->value});
  }
}

void PeakSearch::add(const Chance& chance) {
  if (!is_higher(chance.most, found_.value)) {
    return;
  }
  // What steps show goes before guesses, which may be wild beside a pole.
  const auto comes_before = [&](const Chance& other) {
    return chance.climb.is_guess() == other.climb.is_guess() ? is_higher(chance.most, other.most)
                                                             : other.climb.is_guess();
  };
  std::size_t at = count_;
  while (at > 0 && comes_before(climbs_[at - 1])) {
    --at;
  }
  if (at == kMostClimbs) {
    return;
  }
  count_ = std::min(count_ + 1, kMostClimbs);
  for (std::size_t i = count_ - 1; i > at; --i) {
    climbs_[i] = climbs_[i - 1];
  }
  climbs_[at] = chance;
}

std::optional<double> PeakSearch::next() {
  while (now_ < count_ && !(fold_ && !is_higher(*fold_, found_.value))) {
    // Another climb may have come higher than it could.
    const bool is_hopeless = !is_climbing_ && !is_higher(climbs_[now_].most, found_.value);
    const std::optional<PeakSample>& promise = climbs_[now_].climb.promise();
    if (promise && !is_hopeless) {
      is_climbing_ = true;
      return promise->share;
    }
    end_climb();
  }
  return std::nullopt;
}

void PeakSearch::take(const std::optional<double>& value) {
  if (value) {
    climbs_[now_].climb.take(*value);
  } else {
    end_climb();
  }
}

void PeakSearch::end_climb() {
  const PeakSample& best = climbs_[now_++].climb.best();
  is_climbing_ = false;
  if (is_higher(best.value, found_.value)) {
    found_ = best;
    is_better_ = true;
  }
}

}  // namespace kinestat
