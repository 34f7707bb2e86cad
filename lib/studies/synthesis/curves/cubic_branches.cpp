#include "studies/synthesis/curves/cubic_branches.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/contract.hpp"
#include "core/synthesis_tolerance.hpp"
#include "core/tolerance.hpp"
#include "math/dense/polynomial.hpp"

namespace kinestat {

namespace {

// Twice the bilinear form of the quadratic terms.
double bilinear(const PlaneCubic& cubic, const Point& e, const Point& f) {
  return 2.0 * cubic.q[0] * e.real() * f.real() + 2.0 * cubic.q[2] * e.imag() * f.imag() +
         cubic.q[1] * (e.real() * f.imag() + e.imag() * f.real());
}

// On the line n t + e s: a(t) s² + b(t) s + c(t) = 0, each a polynomial in t.
struct Slices {
  Point n;
  Point e;
  std::vector<double> a, b, c;

  explicit Slices(const PlaneCubic& cubic) : n(cubic.normal()), e(left_of(n)) {
    const Point linear(cubic.l[0], cubic.l[1]);
    const double size = std::hypot(cubic.k[0], cubic.k[1]);
    a = {cubic.quadratic(e), size};
    b = {dot(linear, e), bilinear(cubic, n, e)};
    c = {cubic.c, dot(linear, n), cubic.quadratic(n), size};
  }

  // b² - 4 a c.
  std::vector<double> discriminant() const {
    std::vector<double> result(5, 0.0);
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t j = 0; j < 2; ++j) {
        result[i + j] += b[i] * b[j];
      }
      for (std::size_t j = 0; j < 4; ++j) {
        result[i + j] -= 4.0 * a[i] * c[j];
      }
    }
    return result;
  }

  // The root with +√ or -√, without cancellation; far away where it is infinite.
  Point point(double t, double sign) const {
    const double at = polynomial_value(a, t);
    const double bt = polynomial_value(b, t);
    const double ct = polynomial_value(c, t);
    const double root = std::sqrt(std::max(bt * bt - 4.0 * at * ct, 0.0));
    const bool adds = (bt <= 0.0) == (sign > 0.0);
    const double denominator = -bt - sign * root;
    const bool is_double = !adds && denominator == 0.0;
    const double s = adds || is_double ? (-bt + sign * root) / (2.0 * at) : 2.0 * ct / denominator;
    return n * t + e * s;
  }
};

// The two roots over an interval of t as one way: one root forth for turns from 0 to π, the other
// back; t = middle - half cos(turn), so that ends in which they meet are passed smoothly.
struct Way {
  const Slices& slices;
  double low = 0.0;
  double high = 0.0;

  Point point(double turn) const {
    const double t = 0.5 * (low + high) - 0.5 * (high - low) * std::cos(turn);
    return slices.point(t, turn <= std::numbers::pi ? 1.0 : -1.0);
  }
};

class Sampler {
 public:
  Sampler(const PlaneCubic& cubic, const Point& middle, double radius, int count)
      : cubic_(cubic),
        slices_(cubic),
        middle_((middle - cubic.centre) / cubic.length),
        radius_(radius / cubic.length) {
    find_intervals();
    double length = 0.0;
    for (const Interval& interval : intervals_) {
      length += length_inside({.slices = slices_, .low = interval.low, .high = interval.high});
    }
    longest_step_ = length / count;
  }

  std::vector<CurveBranch> run() {
    for (const Interval& interval : intervals_) {
      add_interval(interval);
    }
    add_line();
    return std::move(branches_);
  }

 private:
  struct Interval {
    double low = 0.0;
    double high = 0.0;
    bool low_meets = false;  // whether the two roots meet in the end
    bool high_meets = false;
  };

  static constexpr int kCoarseSteps = 128;
  static constexpr int kHalvings = 12;

  // Where an interval is tried: not in its middle, which is a touching zero where the curve is
  // symmetric.
  static constexpr double kInside = 0.41;

  void find_intervals() {
    const double at = dot(slices_.n, middle_);
    const std::vector<double> discriminant = slices_.discriminant();
    std::vector<double> marks = find_sign_changes(discriminant, at - radius_, at + radius_);
    marks.insert(marks.begin(), at - radius_);
    marks.push_back(at + radius_);
    for (std::size_t i = 1; i < marks.size(); ++i) {
      const double between = marks[i - 1] + kInside * (marks[i] - marks[i - 1]);
      // Rounding splits a touching zero, as of a line that belongs to the curve, into two.
      const bool is_wide = marks[i] - marks[i - 1] > kDoublePoint * radius_;
      if (is_wide && polynomial_value(discriminant, between) > 0.0) {
        intervals_.push_back({.low = marks[i - 1],
                              .high = marks[i],
                              .low_meets = i > 1,
                              .high_meets = i + 1 < marks.size()});
      }
    }
  }

  bool is_inside(const Point& point) const {
    return std::abs(point - middle_) <= radius_ * (1.0 + kSameValue);
  }

  double length_inside(const Way& way) const {
    double length = 0.0;
    Point before = way.point(0.0);
    for (int i = 1; i <= kCoarseSteps; ++i) {
      const Point now = way.point(2.0 * std::numbers::pi * i / kCoarseSteps);
      const double step = std::abs(now - before);
      length += is_inside(now) && is_inside(before) ? step : 0.0;
      before = now;
    }
    return length;
  }

  void add_point(const Point& point) {
    if (!is_inside(point)) {
      finish();
      has_gap_ = true;
      return;
    }
    current_.points.push_back(cubic_.centre + cubic_.length * point);
  }

  void finish() {
    if (current_.points.size() > 1) {
      branches_.push_back(std::move(current_));
    }
    current_ = {};
  }

  // The way from one turn to another without its beginning, halved until its steps are short.
  // What leaves the circle is followed to its edge.
  void add_way(const Way& way, double from, double to, int halvings) {
    const Point begin = way.point(from);
    const Point end = way.point(to);
    const bool matters = is_inside(begin) || is_inside(end);
    if (halvings > 0 && matters && !(std::abs(end - begin) <= longest_step_)) {
      const double middle = 0.5 * (from + to);
      add_way(way, from, middle, halvings - 1);
      add_way(way, middle, to, halvings - 1);
      return;
    }
    add_point(end);
  }

  void add_interval(const Interval& interval) {
    const Way way{.slices = slices_, .low = interval.low, .high = interval.high};
    const std::size_t first = branches_.size();
    has_gap_ = false;
    add_point(way.point(0.0));
    for (int i = 0; i < kCoarseSteps; ++i) {
      const double step = 2.0 * std::numbers::pi / kCoarseSteps;
      if (2 * i == kCoarseSteps && !interval.high_meets) {
        finish();
        has_gap_ = true;
      }
      add_way(way, step * i, step * (i + 1), kHalvings);
    }
    current_.is_closed = interval.low_meets && !has_gap_;
    finish();
    join_ends(first, interval.low_meets);
  }

  // Where the way begins and ends in one point, but has a gap elsewhere, both parts are one.
  void join_ends(std::size_t first, bool low_meets) {
    if (!low_meets || !has_gap_ || branches_.size() < first + 2) {
      return;
    }
    CurveBranch& head = branches_[first];
    CurveBranch& tail = branches_.back();
    if (std::abs(tail.points.back() - head.points.front()) >
        kDoublePoint * radius_ * cubic_.length) {
      return;
    }
    tail.points.insert(tail.points.end(), head.points.begin() + 1, head.points.end());
    std::swap(head, tail);
    branches_.pop_back();
  }

  // At the asymptote the quadratic equation is linear; if nothing is left of it, the asymptote
  // belongs to the curve.
  void add_line() {
    if (!(slices_.a[1] > 0.0)) {
      return;
    }
    const double t = -slices_.a[0] / slices_.a[1];
    const double b = std::abs(polynomial_value(slices_.b, t));
    const double c = std::abs(polynomial_value(slices_.c, t));
    const double away = t - dot(slices_.n, middle_);
    if (std::max(b, c) > kRankZero * std::max(1.0, std::abs(t * t * t)) ||
        std::abs(away) >= radius_) {
      return;
    }
    const double half = std::sqrt(radius_ * radius_ - away * away);
    const double foot = dot(slices_.e, middle_);
    for (const double s : {foot - half, foot + half}) {
      current_.points.push_back(cubic_.centre + cubic_.length * (slices_.n * t + slices_.e * s));
    }
    finish();
  }

  const PlaneCubic& cubic_;
  Slices slices_;
  Point middle_;
  double radius_;
  double longest_step_ = 0.0;
  std::vector<Interval> intervals_;
  std::vector<CurveBranch> branches_;
  CurveBranch current_;
  bool has_gap_ = false;
};

}  // namespace

std::vector<CurveBranch> sample(const PlaneCubic& cubic,
                                const Point& middle,
                                double radius,
                                int count) {
  KINESTAT_EXPECTS(radius > 0.0 && count > 1);
  return Sampler(cubic, middle, radius, count).run();
}

}  // namespace kinestat
