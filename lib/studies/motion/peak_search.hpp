// Where a value of a motion is greatest between its steps.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "studies/motion/peak_climb.hpp"

namespace kinestat {

/// The most promising climbs of one value, one after the other.
class PeakSearch {
 public:
  /// Of the polynomials that say where a peak may be.
  static constexpr std::size_t kMostPoints = 6;

  /// `found`: the greatest value that is known; `fold`: at which the value is folded, none is
  /// above. `is_size`: values are what sizes are below zero; these may come to zero in straight
  /// lines, and bend sharply near it, where their squares do not.
  PeakSearch(double found, std::optional<double> fold, bool is_size = false)
      : fold_(fold), is_size_(is_size), found_{.share = 0.0, .value = found} {}

  /// All that may be a peak among steps that follow each other without a jump: one that is the
  /// greatest of three, and between two others where a polynomial through some has one. `height`
  /// answers what rises and falls as the value of a step does, `sample` the step itself.
  template <class Height, class SampleAt>
  void add_run(std::size_t count, const Height& height, const SampleAt& sample);

  void add_run(std::span<const PeakSample> run) {
    add_run(
        run.size(),
        [&](std::size_t i) { return run[i].value; },
        [&](std::size_t i) { return run[i]; });
  }

  /// Where to look next; empty where all climbs have ended.
  std::optional<double> next();

  /// The value there; empty where it has none.
  void take(const std::optional<double>& value);

  /// Where the value is greater than what was known; empty where nowhere.
  std::optional<PeakSample> better() const {
    return is_better_ ? std::optional(found_) : std::nullopt;
  }

 private:
  static constexpr std::size_t kMostClimbs = 3;

  // Some steps of a run, and which of them is meant.
  struct Window {
    std::array<PeakSample, kMostPoints> steps = {};
    std::size_t count = 0;
    std::size_t at = 0;

    std::span<const PeakSample> span() const { return std::span(steps).first(count); }
  };

  void add_top(const Window& by);
  void add_behind(const Window& by);
  void add_at_end(const Window& by);

  // A climb, and how high it may come.
  struct Chance {
    PeakClimb climb;
    double most = 0.0;
  };

  // Among those that promise most, if it is higher than what is found.
  void add(const Chance& chance);
  void end_climb();

  std::array<Chance, kMostClimbs> climbs_;  // what promises most first
  std::size_t count_ = 0;
  std::size_t now_ = 0;
  bool is_climbing_ = false;
  std::optional<double> fold_;
  bool is_size_ = false;
  PeakSample found_;
  bool is_better_ = false;
};

template <class Height, class SampleAt>
void PeakSearch::add_run(std::size_t count, const Height& height, const SampleAt& sample) {
  const auto window = [&](std::size_t first, std::size_t most, std::size_t at) {
    Window by;
    for (std::size_t i = first; i < count && by.count < most; ++i) {
      by.steps[by.count++] = sample(i);
    }
    by.at = at - first;
    return by;
  };
  const auto first_of = [&](std::size_t at, std::size_t before, std::size_t most) {
    const std::size_t wanted = at < before ? 0 : at - before;
    return count < most ? 0 : std::min(wanted, count - most);
  };
  // Rises from one step to the next; a top is where they change their sign.
  double before = 0.0;
  // A parabola rises from an end by no more than half of what it falls then and an eighth of the
  // second difference.
  const auto may_be_at = [&](std::size_t end, std::size_t next, std::size_t third) {
    const double there = sample(end).value;
    const double fall = there - sample(next).value;
    const double bend = fall - (sample(next).value - sample(third).value);
    return is_size_ || there + 0.5 * std::abs(fall) + 0.125 * std::abs(bend) > found_.value;
  };
  for (std::size_t i = 0; count > 2 && i + 1 < count; ++i) {
    const double here = height(i);
    const double rise = height(i + 1) - here;
    const double behind = i + 2 < count ? height(i + 2) - height(i + 1) : 0.0;
    const bool is_level_end = i + 2 == count && rise == 0.0 && before > 0.0;
    if (i > 0 && ((before >= 0.0 && rise < 0.0) || is_level_end)) {
      add_top(window(first_of(i, 2, 5), 5, i));
    } else if (i == 0 && rise < 0.0) {
      if (may_be_at(0, 1, 2)) {
        add_at_end(window(0, kMostPoints, 0));
      }
    } else if (i + 2 == count && rise > 0.0) {
      if (may_be_at(i + 1, i, i - 1)) {
        add_at_end(window(first_of(i + 1, kMostPoints - 1, kMostPoints), kMostPoints, i + 1));
      }
    } else if (rise > 0.0 ? before > 2.0 * rise && behind >= 0.0
                          : behind < 2.0 * rise && before <= 0.0) {
      add_behind(window(first_of(i, 1, 4), 4, i));
    }
    before = rise;
  }
}

}  // namespace kinestat
