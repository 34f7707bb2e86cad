#include "studies/motion/peak_search.hpp"

#include <algorithm>
#include <cmath>
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

// How high lines through two samples on either side of one meet, as at a kink.
double kink_above(std::span<const PeakSample> run, std::size_t at) {
  if (at < 2 || at + 2 >= run.size()) {
    return run[at].value;
  }
  const auto line = [&](std::size_t one, std::size_t other) {
    const double slope = (run[other].value - run[one].value) / (run[other].share - run[one].share);
    return std::pair(slope, run[one].value - slope * (run[one].share - run[at].share));
  };
  const auto [rise, low] = line(at - 2, at - 1);
  const auto [fall, high] = line(at + 1, at + 2);
  const double way = (high - low) / (rise - fall);
  const bool is_inside =
      way > run[at - 1].share - run[at].share && way < run[at + 1].share - run[at].share;
  return is_inside ? low + rise * way : run[at].value;
}

// Of what a climb promises beside a sample: what the lines of a kink promise more, or twice of what
// a cubic says differs by.
double error_of(const PeakClimb& climb, std::span<const PeakSample> run, std::size_t at) {
  const std::optional<PeakSample>& promise = climb.promise();
  if (!promise) {
    return 0.0;
  }
  const std::size_t piece = promise->share < run[at].share ? at - 1 : at;
  const Interpolant cubic(around(run, piece, 4), run[piece].share);
  const double bent = 2.0 * std::abs(cubic.at(promise->share - run[piece].share) - promise->value);
  return std::max(bent, kink_above(run, at) - promise->value);
}

}  // namespace

void PeakSearch::add_top(const Window& by) {
  const PeakClimb climb({by.steps[by.at - 1], by.steps[by.at], by.steps[by.at + 1]}, fold_);
  add(climb, fold_ ? 0.0 : error_of(climb, by.span(), by.at));
}

void PeakSearch::add_behind(const Window& by) {
  if (const auto top = top_behind(by.span(), by.at)) {
    add(PeakClimb(by.steps[by.at], *top, by.steps[by.at + 1], fold_), 0.0);
  }
}

void PeakSearch::add_at_end(const Window& by) {
  const std::size_t piece = by.at == 0 ? 0 : by.at - 1;
  if (const auto top = top_at_end(by.span(), by.at == 0)) {
    add(PeakClimb(by.steps[piece], *top, by.steps[piece + 1], fold_), 0.0);
  }
}

void PeakSearch::add(const PeakClimb& climb, double error) {
  const std::optional<PeakSample>& promise = climb.promise();
  if (!promise || !is_higher(promise->value + error, found_.value)) {
    return;
  }
  // What steps show goes before guesses, which may be wild beside a pole.
  const auto comes_before = [&](const PeakClimb& other) {
    return climb.is_guess() == other.is_guess() ? is_higher(promise->value, other.promise()->value)
                                                : other.is_guess();
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
  climbs_[at] = climb;
}

std::optional<double> PeakSearch::next() {
  while (now_ < count_ && !(fold_ && !is_higher(*fold_, found_.value))) {
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
  if (is_higher(best.value, found_.value)) {
    found_ = best;
    is_better_ = true;
  }
}

}  // namespace kinestat
