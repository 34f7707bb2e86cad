#include "studies/motion/task/friction_places.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>

#include "core/extreme_tolerance.hpp"
#include "core/motion_tolerance.hpp"
#include "math/dense/first_crossing.hpp"
#include "studies/motion/task/figures/motion_steps.hpp"

namespace kinestat {

namespace {

class StopFinder {
 public:
  StopFinder(const MotionPlan& plan, std::span<const FrictionPlace> rows)
      : schedule_(*plan.schedule), steps_(plan.steps), rows_(rows) {}

  std::vector<double> run() {
    const std::vector<double> turns = schedule_.turns();
    auto turn = turns.begin();
    for (std::size_t r = 1; r < rows_.size(); ++r) {
      const double end = rows_[r].step;
      double before = rows_[r - 1].step;
      bool is_turn = false;
      for (; turn != turns.end() && nearest_row(*turn * steps_) <= end; ++turn) {
        const double step = nearest_row(*turn * steps_);
        const double just_before = DriveSchedule::before(*turn) * steps_;
        if (step < end && step > before) {
          look(before, is_turn, step, true);
          before = step;
          is_turn = true;
          if (stands_at(step)) {
            found_.push_back(step);
          }
        }
        // It may set out with a jump of its speed.
        if (!stands_at(step) && stands_at(just_before)) {
          found_.push_back(just_before);
        }
      }
      look(before, is_turn, end, false);
    }
    std::ranges::sort(found_);
    return std::move(found_);
  }

 private:
  double speed(std::size_t drive, double step) const {
    return std::abs(schedule_.at(drive, step / steps_).speed);
  }

  bool stands_at(double step) const {
    for (std::size_t d = 0; d < schedule_.drive_count(); ++d) {
      if (speed(d, step) == 0.0) {
        return true;
      }
    }
    return false;
  }

  // Whether a drive that stops at both ends moves between them.
  void look(double begin, bool is_begin_turn, double end, bool is_end_turn) {
    const double middle = std::midpoint(begin, end);
    for (std::size_t d = 0; d < schedule_.drive_count(); ++d) {
      const double still = kSameStep * speed(d, middle);
      if (still > 0.0 && (is_begin_turn || speed(d, begin) <= still) &&
          (is_end_turn || speed(d, end) <= still)) {
        found_.push_back(middle);
        return;
      }
    }
  }

  const DriveSchedule& schedule_;
  double steps_;
  std::span<const FrictionPlace> rows_;
  std::vector<double> found_;
};

class TurnWalk {
 public:
  TurnWalk(std::span<const FrictionPlace> places, const FrictionLooks& looks)
      : places_(places), looks_at_(looks) {}

  void look(std::size_t friction, std::vector<double>& found) {
    friction_ = friction;
    const bool slides = std::ranges::any_of(
        places_, [&](const FrictionPlace& one) { return one.sliding.slides(friction); });
    for (std::size_t i = 1; i < places_.size(); ++i) {
      turns_.clear();
      const FrictionSliding& before = places_[i - 1].sliding;
      const FrictionSliding& behind = places_[i].sliding;
      if (before.rates.empty() || behind.rates.empty()) {
        continue;
      }
      const double from = places_[i - 1].step;
      const double to = places_[i].step;
      if (before.slides(friction) && behind.slides(friction)) {
        const bool turns = before.rates[friction].dot(behind.rates[friction]) < 0.0;
        if (turns) {
          halve(from, to, before.rates[friction], behind.rates[friction]);
        } else if (may_dip(i)) {
          walk(from, to, before.rates[friction]);
          drop_last();
        }
      } else if (before.slides(friction)) {
        walk(from, to, before.rates[friction]);
      } else if (behind.slides(friction)) {
        walk(to, from, behind.rates[friction]);
      } else if (slides && !before.stands && !behind.stands) {
        look_between_rests(std::midpoint(from, to));
      }
      found.insert(found.end(), turns_.begin(), turns_.end());
    }
  }

 private:
  static constexpr int kParts = 2;
  static constexpr std::size_t kMostTurns = 16;
  static constexpr int kMostHalvings = 7;

  struct Look {
    double step = 0.0;
    double speed = 0.0;
  };

  // Where it turns round more than once, it runs less straight from one end to the other than it
  // would else.
  void halve(double from, double to, const Vec3& first, const Vec3& last) {
    const Vec3 along = first.normalized();
    looks_.clear();
    largest_ = 0.0;
    add({.step = from, .speed = first.norm()});
    halve_behind({.step = to, .speed = last.dot(along)}, along, kMostHalvings);
    keep_between();
  }

  void add(const Look& look) {
    looks_.push_back(look);
    largest_ = std::max(largest_, std::abs(look.speed));
  }

  // From the last look to there.
  void halve_behind(const Look& end, const Vec3& along, int left) {
    const Look begin = looks_.back();
    const double step = std::midpoint(begin.step, end.step);
    const std::vector<Vec3> there = looks_at_.speeds(step);
    if (!there.empty()) {
      const Look middle{.step = step, .speed = there[friction_].dot(along)};
      const double bend = std::abs(middle.speed - std::midpoint(begin.speed, end.speed));
      halve_if(begin, middle, bend, along, left);
      add(middle);
      halve_if(middle, end, bend, along, left);
    }
    add(end);
  }

  void halve_if(const Look& begin, const Look& end, double bend, const Vec3& along, int left) {
    constexpr double kStraight = 0.25;
    const double least = begin.speed * end.speed < 0.0
                             ? kStraight * std::abs(end.speed - begin.speed)
                             : std::min(std::abs(begin.speed), std::abs(end.speed));
    if (left > 0 && bend > least) {
      halve_behind(end, along, left - 1);
      looks_.pop_back();
    }
  }

  // Of the stretches in which it slides one way, those at the ends are known: the fastest of each
  // other.
  void keep_between() {
    std::erase_if(looks_, [this](const Look& one) {
      return std::abs(one.speed) <= kDeepestGraze * largest_;
    });
    std::optional<Look> fastest;
    for (std::size_t i = 1; i < looks_.size(); ++i) {
      const bool turns = looks_[i - 1].speed * looks_[i].speed < 0.0;
      if (turns && fastest) {
        turns_.push_back(fastest->step);
      }
      if (turns || (fastest && std::abs(looks_[i].speed) > std::abs(fastest->speed))) {
        fastest = looks_[i];
      }
    }
  }

  void look_between_rests(double step) {
    const std::vector<Vec3> there = looks_at_.speeds(step);
    if (!there.empty() && !there[friction_].isZero(0.0)) {
      turns_.push_back(step);
    }
  }

  // Behind an even number of turns it slides as at the end of the way.
  void drop_last() {
    if (!turns_.empty() && turns_.size() % 2 == 0) {
      turns_.pop_back();
    }
  }

  // Places at which it slides back, and on again, and so forth.
  void walk(double from, double to, const Vec3& first) {
    Vec3 along = first.normalized();
    while (turns_.size() < kMostTurns) {
      const auto turn = crossing(from, to, along);
      if (!turn || *turn == to) {
        return;
      }
      turns_.push_back(*turn);
      from = *turn;
      along = -along;
    }
  }

  // A way back is walked as one ahead.
  std::optional<double> crossing(double from, double to, const Vec3& along) const {
    const double sense = to < from ? -1.0 : 1.0;
    const ValueAt value = [&](double way) -> std::optional<double> {
      const std::vector<Vec3> there = looks_at_.speeds(from + sense * way);
      return there.empty() ? std::nullopt : std::optional(there[friction_].dot(along));
    };
    const auto found = find_crossing(value, 0.0, sense * (to - from), kParts);
    return found ? std::optional(from + sense * found->behind) : std::nullopt;
  }

  std::optional<double> speed_of(std::size_t place, const Vec3& along) const {
    return place < places_.size() && !places_[place].sliding.rates.empty()
               ? std::optional(places_[place].sliding.rates[friction_].dot(along))
               : std::nullopt;
  }

  // In the first and the last step always; else if it slides slowest at one end of the step, and
  // not steadily.
  bool may_dip(std::size_t place) const {
    return place == 1 || place + 1 == places_.size() || dips_at(place - 1) || dips_at(place);
  }

  bool dips_at(std::size_t place) const {
    const Vec3 along = places_[place].sliding.rates[friction_].normalized();
    const std::optional<double> a = speed_of(place - 1, along);
    const std::optional<double> b = speed_of(place, along);
    const std::optional<double> c = speed_of(place + 1, along);
    return a && b && c && *b <= *a && *b <= *c && *b < (1.0 - kSameStep) * std::max(*a, *c);
  }

  std::span<const FrictionPlace> places_;
  const FrictionLooks& looks_at_;
  std::size_t friction_ = 0;
  std::vector<double> turns_;  // of a walk, or of what was halved
  std::vector<Look> looks_;    // in order, of what is halved
  double largest_ = 0.0;       // of their speeds
};

// In order, each once.
std::vector<double> places_of_turns(const Mechanism& mechanism,
                                    std::span<const FrictionPlace> places,
                                    const FrictionLooks& looks) {
  std::vector<double> found;
  TurnWalk walk(places, looks);
  for (std::size_t f = 0; f < mechanism.frictions.size(); ++f) {
    if (!vanishes_at_rest(mechanism.frictions[f])) {
      walk.look(f, found);
    }
  }
  std::ranges::sort(found);
  const auto is_same = [](double a, double b) { return b - a < kSameStep; };
  found.erase(std::unique(found.begin(), found.end(), is_same), found.end());
  return found;
}

void add_places(std::span<const double> steps,
                const FrictionLooks& looks,
                std::vector<FrictionPlace>& places) {
  for (const double step : steps) {
    if (std::optional<FrictionSliding> sliding = looks.place(step)) {
      places.push_back({.step = step, .sliding = *std::move(sliding)});
    }
  }
  std::ranges::stable_sort(places, {}, &FrictionPlace::step);
}

}  // namespace

void add_places_between(const Mechanism& mechanism,
                        const MotionPlan& plan,
                        const FrictionLooks& looks,
                        std::vector<FrictionPlace>& rows) {
  if (std::ranges::all_of(mechanism.frictions, vanishes_at_rest)) {
    return;
  }
  if (plan.schedule) {
    add_places(StopFinder(plan, rows).run(), looks, rows);
  }
  add_places(places_of_turns(mechanism, rows, looks), looks, rows);
}

}  // namespace kinestat
