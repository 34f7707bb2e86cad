#include "studies/synthesis/curves/plane_cubic.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "studies/synthesis/dyads/bounded_point.hpp"

namespace kinestat {

namespace {

// k1, k2, q11, q12, q22, l1, l2, c.
template <class Number>
using Coefficients = std::array<Number, 8>;

// About another centre and in another unit: u + iv = m + s w with the new coordinates w, where
// (|m|² + 2 s m.w + s²|w|²)(k.m + s k.w), the quadratic and the linear terms are taken by powers of
// w.
template <class Number>
Coefficients<Number> shifted(const Coefficients<Number>& a,
                             const Number& m_x,
                             const Number& m_y,
                             const Number& s) {
  const auto& [k1, k2, q11, q12, q22, l1, l2, c] = a;
  const auto twice = [](const Number& x) { return x + x; };
  const Number square = m_x * m_x + m_y * m_y;
  const Number along = k1 * m_x + k2 * m_y;
  const Number s2 = s * s;
  const Number s3 = s2 * s;
  return {s3 * k1,
          s3 * k2,
          s2 * (along + twice(m_x * k1) + q11),
          s2 * (twice(m_x * k2 + m_y * k1) + q12),
          s2 * (along + twice(m_y * k2) + q22),
          s * (square * k1 + twice(along * m_x) + twice(q11 * m_x) + q12 * m_y + l1),
          s * (square * k2 + twice(along * m_y) + twice(q22 * m_y) + q12 * m_x + l2),
          square * along + q11 * m_x * m_x + q12 * m_x * m_y + q22 * m_y * m_y + l1 * m_x +
              l2 * m_y + c};
}

Coefficients<double> coefficients_of(const PlaneCubic& cubic) {
  return {
      cubic.k[0], cubic.k[1], cubic.q[0], cubic.q[1], cubic.q[2], cubic.l[0], cubic.l[1], cubic.c};
}

Coefficients<double> bounds_of(const PlaneCubic& cubic) {
  const CubicBounds& of = cubic.bounds;
  return {of.k[0], of.k[1], of.q[0], of.q[1], of.q[2], of.l[0], of.l[1], of.c};
}

double largest_of(const Coefficients<double>& all) {
  double largest = 0.0;
  for (const double one : all) {
    largest = std::max(largest, std::abs(one));
  }
  return largest > 0.0 ? largest : 1.0;
}

BoundedNumber within(double value, double bound) {
  return {.value = value, .bound = bound};
}

// The quadratic terms, with their bounds, at a vector.
BoundedNumber bounded_quadratic(const PlaneCubic& cubic, const BoundedPoint& e) {
  const CubicBounds& of = cubic.bounds;
  return within(cubic.q[0], of.q[0]) * e.x * e.x + within(cubic.q[1], of.q[1]) * e.x * e.y +
         within(cubic.q[2], of.q[2]) * e.y * e.y;
}

// What has these coordinates in a cubic, as a point of the plane.
Point placed(const PlaneCubic& cubic, const BoundedPoint& z) {
  return (BoundedPoint::within(cubic.centre, {0.0, 0.0}) + exactly(cubic.length) * z).zeroed();
}

// The line of the points whose product with `normal` is `offset`, in the units of a cubic.
PlaneLine line_of(const PlaneCubic& cubic,
                  const BoundedPoint& normal,
                  const BoundedNumber& offset) {
  const BoundedNumber size = root(dot(normal, normal));
  const BoundedPoint across = {.x = normal.x / size, .y = normal.y / size};
  const BoundedNumber to_centre = dot(across, BoundedPoint::within(cubic.centre, {0.0, 0.0}));
  return {.normal = across.zeroed(),
          .offset = (exactly(cubic.length) * (offset / size) + to_centre).zeroed()};
}

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
  const BoundedPoint sure_leading = {.x = exactly(0.5) * within(k[0], bounds.k[0]),
                                     .y = exactly(-0.5) * within(k[1], bounds.k[1])};
  const BoundedPoint middle = {
      .x = exactly(0.25) * (within(q[0], bounds.q[0]) - within(q[2], bounds.q[2])),
      .y = exactly(-0.25) * within(q[1], bounds.q[1])};
  return placed(*this, exactly(-1.0) * conj(middle / sure_leading));
}

std::optional<PlaneLine> PlaneCubic::asymptote() const {
  const double size = std::hypot(k[0], k[1]);
  if (!(size > 0.0)) {
    return std::nullopt;
  }
  const BoundedPoint across = BoundedPoint::within({k[0], k[1]}, {bounds.k[0], bounds.k[1]});
  const BoundedPoint along = {.x = exactly(0.0) - across.y, .y = across.x};
  const BoundedNumber square = dot(across, across);
  return line_of(*this, across, exactly(0.0) - bounded_quadratic(*this, along) / square);
}

std::optional<Circle> PlaneCubic::circle() const {
  const double leading = 0.5 * (q[0] + q[2]);
  const double oblong = std::abs(q[0] - q[2]) + std::abs(q[1]);
  if (focus() || !(std::abs(leading) > kSameValue) || oblong > kSameValue * std::abs(leading)) {
    return std::nullopt;
  }
  const BoundedNumber sure_leading =
      exactly(0.5) * (within(q[0], bounds.q[0]) + within(q[2], bounds.q[2]));
  const BoundedNumber share = exactly(-0.5) / sure_leading;
  const BoundedPoint middle = {.x = share * within(l[0], bounds.l[0]),
                               .y = share * within(l[1], bounds.l[1])};
  const BoundedNumber square = dot(middle, middle) - within(c, bounds.c) / sure_leading;
  return square.zeroed() > 0.0 ? std::optional(Circle{.centre = placed(*this, middle),
                                                      .radius = length * std::sqrt(square.value)})
                               : std::nullopt;
}

std::optional<PlaneLine> PlaneCubic::line() const {
  const double curved = std::abs(q[0]) + std::abs(q[1]) + std::abs(q[2]);
  const double size = std::hypot(l[0], l[1]);
  if (focus() || curved > kSameValue || !(size > kSameValue)) {
    return std::nullopt;
  }
  return line_of(*this,
                 BoundedPoint::within({l[0], l[1]}, {bounds.l[0], bounds.l[1]}),
                 exactly(0.0) - within(c, bounds.c));
}

Point PlaneCubic::normal() const {
  const double size = std::hypot(k[0], k[1]);
  return size > 0.0 ? Point(k[0], k[1]) / size : Point(1.0, 0.0);
}

double PlaneCubic::quadratic(const Point& e) const {
  return q[0] * e.real() * e.real() + q[1] * e.real() * e.imag() + q[2] * e.imag() * e.imag();
}

PlaneCubic PlaneCubic::about(const Point& new_centre, double new_length) const {
  KINESTAT_EXPECTS(new_length > 0.0);
  const Point m = (new_centre - centre) / length;
  Coefficients<double> all =
      shifted(coefficients_of(*this), m.real(), m.imag(), new_length / length);
  const double largest = largest_of(all);
  for (double& one : all) {
    one /= largest;
  }
  return {.k = {all[0], all[1]},
          .q = {all[2], all[3], all[4]},
          .l = {all[5], all[6]},
          .c = all[7],
          .centre = new_centre,
          .length = new_length};
}

PlaneCubic PlaneCubic::settled_about(const Point& new_centre, double new_length) const {
  KINESTAT_EXPECTS(new_length > 0.0);
  Coefficients<BoundedNumber> all;
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i] = within(coefficients_of(*this)[i], bounds_of(*this)[i]);
  }
  const BoundedNumber unit = exactly(length);
  all = shifted(all,
                (exactly(new_centre.real()) - exactly(centre.real())) / unit,
                (exactly(new_centre.imag()) - exactly(centre.imag())) / unit,
                exactly(new_length) / unit);
  Coefficients<double> values{};
  Coefficients<double> errors{};
  std::ranges::transform(all, values.begin(), &BoundedNumber::zeroed);
  std::ranges::transform(all, errors.begin(), &BoundedNumber::bound);
  const double largest = largest_of(values);
  for (std::size_t i = 0; i < all.size(); ++i) {
    values[i] /= largest;
    errors[i] /= largest;
  }
  return {.k = {values[0], values[1]},
          .q = {values[2], values[3], values[4]},
          .l = {values[5], values[6]},
          .c = values[7],
          .centre = new_centre,
          .length = new_length,
          .bounds = {.k = {errors[0], errors[1]},
                     .q = {errors[2], errors[3], errors[4]},
                     .l = {errors[5], errors[6]},
                     .c = errors[7]}};
}

}  // namespace kinestat
