#include "math/dense/first_crossing.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/extreme_tolerance.hpp"

namespace kinestat {

namespace {

// Beside the ends of the way, as share of a part: whether it falls there.
constexpr double kBesideEnd = 0x1p-6;

// A bottom is found by fewer parabolas.
constexpr int kMostParabolas = 16;

// A parabola that promises less than this share of what is left above zero ends the descent.
constexpr double kLeastPromise = 0.25;

// A look at the bottom of the last parabola goes aside by this share.
constexpr double kAside = 0.02;

struct Look {
  double place = 0.0;
  double value = 0.0;
};

// Of the parabola through three looks, the middle one below both others.
Look bottom_of(const Look& a, const Look& b, const Look& c) {
  const double left = (b.value - a.value) / (b.place - a.place);
  const double right = (c.value - b.value) / (c.place - b.place);
  const double curvature = (right - left) / (c.place - a.place);
  const double slope = left + curvature * (b.place - a.place);  // at the middle one
  if (!(curvature > 0.0)) {
    return {.place = b.place, .value = b.value};
  }
  return {.place = b.place - slope / (2.0 * curvature),
          .value = b.value - slope * slope / (4.0 * curvature)};
}

class CrossingSearch {
 public:
  CrossingSearch(const ValueAt& value, double from, double to, int parts)
      : value_(value), from_(from), to_(to), parts_(parts) {}

  std::optional<SignChange> run() {
    const double part = (to_ - from_) / parts_;
    look(from_);
    look(from_ + kBesideEnd * part);
    for (int i = 1; i <= parts_; ++i) {
      if (i == parts_) {
        if (std::optional<SignChange> dip = look_on(to_ - kBesideEnd * part)) {
          return dip;
        }
      }
      const double place = i == parts_ ? to_ : from_ + i * part;
      if (std::optional<SignChange> dip = look_on(place)) {
        return dip;
      }
      if (!looks_.empty() && looks_.back().place == place && looks_.back().value < 0.0) {
        return SignChange{.before = last_positive_, .behind = place};
      }
    }
    return std::nullopt;
  }

 private:
  void look(double place) {
    const std::optional<double> value = value_(place);
    if (!value) {
      looks_.clear();
      return;
    }
    looks_.push_back({.place = place, .value = *value});
    largest_ = std::max(largest_, std::abs(*value));
  }

  // With what dips since the look before the last.
  std::optional<SignChange> look_on(double place) {
    if (!looks_.empty() && looks_.back().value >= 0.0) {
      last_positive_ = looks_.back().place;
    }
    look(place);
    if (looks_.size() < 3) {
      return std::nullopt;
    }
    const auto last = looks_.end();
    return dip(*(last - 3), *(last - 2), *(last - 1));
  }

  bool is_below_zero(double value) const { return value < -kDeepestGraze * largest_; }

  std::optional<SignChange> dip(Look a, Look b, Look c) {
    if (!(a.value >= 0.0 && c.value >= 0.0 && b.value < a.value && b.value <= c.value)) {
      return std::nullopt;
    }
    for (int round = 0; round < kMostParabolas; ++round) {
      if (is_below_zero(b.value)) {
        return SignChange{.before = a.place, .behind = b.place};
      }
      const Look bottom = bottom_of(a, b, c);
      const bool is_hopeless =
          round > 0 && !(b.value - bottom.value > kLeastPromise * std::max(b.value, 0.0));
      if (is_hopeless) {
        return std::nullopt;
      }
      double place = bottom.place;
      const double aside = kAside * (c.place - a.place);
      if (std::abs(place - b.place) < aside) {
        place = c.place - b.place > b.place - a.place ? b.place + aside : b.place - aside;
      }
      if (!(place > a.place && place < c.place) || place == b.place) {
        return std::nullopt;
      }
      const std::optional<double> value = value_(place);
      if (!value) {
        return std::nullopt;
      }
      const Look here{.place = place, .value = *value};
      if (here.value < b.value) {
        (place < b.place ? c : a) = b;
        b = here;
      } else {
        (place < b.place ? a : c) = here;
      }
    }
    return std::nullopt;
  }

  const ValueAt& value_;
  double from_;
  double to_;
  int parts_;
  std::vector<Look> looks_;
  double largest_ = 0.0;
  double last_positive_ = from_;
};

}  // namespace

std::optional<SignChange> find_crossing(const ValueAt& value, double from, double to, int parts) {
  return CrossingSearch(value, from, to, parts).run();
}

}  // namespace kinestat
