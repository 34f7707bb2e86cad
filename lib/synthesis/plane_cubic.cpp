#include "synthesis/plane_cubic.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "math/polynomial.hpp"

namespace kinestat {

namespace {

Point normal_of(const PlaneCubic& cubic) {
  const double size = std::hypot(cubic.k[0], cubic.k[1]);
  return size > 0.0 ? Point(cubic.k[0], cubic.k[1]) / size : Point(1.0, 0.0);
}

// The quadratic terms at a vector, and their bilinear form (twice) at two.
double quadratic(const PlaneCubic& cubic, const Point& e) {
  return cubic.q[0] * e.real() * e.real() + cubic.q[1] * e.real() * e.imag() +
         cubic.q[2] * e.imag() * e.imag();
}

double bilinear(const PlaneCubic& cubic, const Point& e, const Point& f) {
  return 2.0 * cubic.q[0] * e.real() * f.real() + 2.0 * cubic.q[2] * e.imag() * f.imag() +
         cubic.q[1] * (e.real() * f.imag() + e.imag() * f.real());
}

// On the line n t + e s: a(t) s² + b(t) s + c(t) = 0, each a polynomial in t.
struct Slices {
  Point n;
  Point e;
  std::vector<double> a, b, c;

  explicit Slices(const PlaneCubic& cubic) : n(normal_of(cubic)), e(left_of(n)) {
    const Point linear(cubic.l[0], cubic.l[1]);
    const double size = std::hypot(cubic.k[0], cubic.k[1]);
    a = {quadratic(cubic, e), size};
    b = {dot(linear, e), bilinear(cubic, n, e)};
    c = {cubic.c, dot(linear, n), quadratic(cubic, n), size};
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
    const double s = adds ? (-bt + sign * root) / (2.0 * at) : 2.0 * ct / (-bt - sign * root);
    return n * t + e * s;
  }
};

class Sampler {
 public:
  Sampler(const PlaneCubic& cubic, const Point& middle, double radius, int count)
      : cubic_(cubic),
        slices_(cubic),
        middle_((middle - cubic.centre) / cubic.length),
        radius_(radius / cubic.length),
        count_(count) {}

  std::vector<CurveBranch> run() {
    const double at = dot(slices_.n, middle_);
    std::vector<double> marks = find_sign_changes(discriminant(), at - radius_, at + radius_);
    marks.insert(marks.begin(), at - radius_);
    marks.push_back(at + radius_);
    for (std::size_t i = 1; i < marks.size(); ++i) {
      const double between = 0.5 * (marks[i - 1] + marks[i]);
      if (polynomial_value(discriminant(), between) >= 0.0 && marks[i] > marks[i - 1]) {
        add_interval(marks[i - 1], marks[i], i > 1, i + 1 < marks.size());
      }
    }
    add_line();
    return std::move(branches_);
  }

 private:
  std::vector<double> discriminant() const { return slices_.discriminant(); }

  bool is_inside(const Point& point) const {
    return std::abs(point - middle_) <= radius_ * (1.0 + kSameValue);
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

  // One root forth, the other back; they meet in ends that are zeros of the discriminant.
  void add_interval(double low, double high, bool low_meets, bool high_meets) {
    constexpr int kFewest = 24;
    const double share = (high - low) / (2.0 * radius_);
    const int steps = std::max(kFewest, static_cast<int>(share * count_ / 2));
    const std::size_t first = branches_.size();
    has_gap_ = false;
    for (const double sign : {1.0, -1.0}) {
      for (int i = 0; i <= steps; ++i) {
        const double turn = std::numbers::pi * i / steps;
        const double middle = 0.5 * (low + high);
        const double t = middle - sign * 0.5 * (high - low) * std::cos(turn);
        // The joint is a point of the first pass.
        if (!(sign < 0.0 && i == 0 && high_meets)) {
          add_point(slices_.point(t, sign));
        }
      }
      if (sign > 0.0 && !high_meets) {
        finish();
        has_gap_ = true;
      }
    }
    current_.is_closed = low_meets && !has_gap_;
    finish();
    join_ends(first, low_meets);
  }

  // Where the way begins and ends in one point, but has a gap elsewhere, both parts are one.
  void join_ends(std::size_t first, bool low_meets) {
    if (!low_meets || !has_gap_ || branches_.size() < first + 2) {
      return;
    }
    CurveBranch& head = branches_[first];
    CurveBranch& tail = branches_.back();
    if (std::abs(tail.points.back() - head.points.front()) > kSameValue * radius_ * cubic_.length) {
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
  int count_;
  std::vector<CurveBranch> branches_;
  CurveBranch current_;
  bool has_gap_ = false;
};

}  // namespace

double PlaneCubic::miss(const Point& point) const {
  const Point z = (point - centre) / length;
  const double u = z.real();
  const double v = z.imag();
  const double square = u * u + v * v;
  const std::array<double, 8> terms = {square * k[0] * u,
                                       square * k[1] * v,
                                       q[0] * u * u,
                                       q[1] * u * v,
                                       q[2] * v * v,
                                       l[0] * u,
                                       l[1] * v,
                                       c};
  double sum = 0.0;
  double size = 0.0;
  for (const double term : terms) {
    sum += term;
    size += std::abs(term);
  }
  return size > 0.0 ? std::abs(sum) / size : 0.0;
}

std::optional<Point> PlaneCubic::focus() const {
  const Point leading = 0.5 * Point(k[0], -k[1]);
  if (leading == Point(0.0, 0.0)) {
    return std::nullopt;
  }
  const Point middle = 0.25 * Point(q[0] - q[2], -q[1]);
  return centre - length * std::conj(middle / leading);
}

std::optional<PlaneLine> PlaneCubic::asymptote() const {
  const double size = std::hypot(k[0], k[1]);
  if (!(size > 0.0)) {
    return std::nullopt;
  }
  const Point normal = normal_of(*this);
  const double offset = -quadratic(*this, left_of(normal)) / size;
  return PlaneLine{.normal = normal, .offset = length * offset + dot(normal, centre)};
}

PlaneCubic PlaneCubic::about(const Point& new_centre, double new_length) const {
  KINESTAT_EXPECTS(new_length > 0.0);
  // u + iv = m + s w with the new coordinates w.
  const Point m = (new_centre - centre) / length;
  const double s = new_length / length;
  const Point kk(k[0], k[1]);
  const double square = std::norm(m);
  const double along = dot(kk, m);
  PlaneCubic result{.centre = new_centre, .length = new_length};
  // (|m|² + 2 s m.w + s²|w|²)(k.m + s k.w), the quadratic and the linear terms, by powers of w.
  const Point linear(l[0], l[1]);
  const Point of_q(2.0 * q[0] * m.real() + q[1] * m.imag(),
                   2.0 * q[2] * m.imag() + q[1] * m.real());
  const Point new_l = s * (square * kk + 2.0 * along * m + of_q + linear);
  result.k = {s * s * s * k[0], s * s * s * k[1]};
  result.q = {s * s * (along + 2.0 * m.real() * k[0] + q[0]),
              s * s * (2.0 * (m.real() * k[1] + m.imag() * k[0]) + q[1]),
              s * s * (along + 2.0 * m.imag() * k[1] + q[2])};
  result.l = {new_l.real(), new_l.imag()};
  result.c = square * along + quadratic(*this, m) + dot(linear, m) + c;
  double largest = std::abs(result.c);
  for (const double x : {result.k[0],
                         result.k[1],
                         result.q[0],
                         result.q[1],
                         result.q[2],
                         result.l[0],
                         result.l[1]}) {
    largest = std::max(largest, std::abs(x));
  }
  for (double* x : {&result.k[0],
                    &result.k[1],
                    &result.q[0],
                    &result.q[1],
                    &result.q[2],
                    &result.l[0],
                    &result.l[1],
                    &result.c}) {
    *x /= largest > 0.0 ? largest : 1.0;
  }
  return result;
}

std::vector<CurveBranch> sample(const PlaneCubic& cubic,
                                const Point& middle,
                                double radius,
                                int count) {
  KINESTAT_EXPECTS(radius > 0.0 && count > 1);
  return Sampler(cubic, middle, radius, count).run();
}

}  // namespace kinestat
