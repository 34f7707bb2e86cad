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
  double time = 0.0;
  double value = 0.0;
};

struct Bottom {
  double time = 0.0;
  double value = 0.0;
};

// Of the parabola through three looks, the middle one below both others.
Bottom bottom_of(const Look& a, const Look& b, const Look& c) {
  const double left = (b.value - a.value) / (b.time - a.time);
  const double right = (c.value - b.value) / (c.time - b.time);
  const double curvature = (right - left) / (c.time - a.time);
  const double slope = left + curvature * (b.time - a.time);  // at the middle one
  if (!(curvature > 0.0)) {
    return {.time = b.time, .value = b.value};
  }
  return {.time = b.time - slope / (2.0 * curvature),
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
      const double time = i == parts_ ? to_ : from_ + i * part;
      if (std::optional<SignChange> dip = look_on(time)) {
        return dip;
      }
      if (!looks_.empty() && looks_.back().time == time && looks_.back().value < 0.0) {
        return SignChange{.before = last_positive_, .behind = time};
      }
    }
    return std::nullopt;
  }

 private:
  void look(double time) {
    const std::optional<double> value = value_(time);
    if (!value) {
      looks_.clear();
      return;
    }
    looks_.push_back({.time = time, .value = *value});
    largest_ = std::max(largest_, std::abs(*value));
  }

  // With what dips since the look before the last.
  std::optional<SignChange> look_on(double time) {
    if (!looks_.empty() && looks_.back().value >= 0.0) {
      last_positive_ = looks_.back().time;
    }
    look(time);
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
        return SignChange{.before = a.time, .behind = b.time};
      }
      const Bottom bottom = bottom_of(a, b, c);
      const bool is_hopeless =
          round > 0 && !(b.value - bottom.value > kLeastPromise * std::max(b.value, 0.0));
      if (is_hopeless) {
        return std::nullopt;
      }
      double time = bottom.time;
      const double aside = kAside * (c.time - a.time);
      if (std::abs(time - b.time) < aside) {
        time = c.time - b.time > b.time - a.time ? b.time + aside : b.time - aside;
      }
      if (!(time > a.time && time < c.time) || time == b.time) {
        return std::nullopt;
      }
      const std::optional<double> value = value_(time);
      if (!value) {
        return std::nullopt;
      }
      const Look here{.time = time, .value = *value};
      if (here.value < b.value) {
        (time < b.time ? c : a) = b;
        b = here;
      } else {
        (time < b.time ? a : c) = here;
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
