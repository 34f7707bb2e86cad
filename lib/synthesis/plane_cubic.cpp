#include "synthesis/plane_cubic.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "core/tolerance.hpp"

namespace kinestat {

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
  const Point across = normal();
  const double offset = -quadratic(left_of(across)) / size;
  return PlaneLine{.normal = across, .offset = length * offset + dot(across, centre)};
}

std::optional<Circle> PlaneCubic::circle() const {
  const double leading = 0.5 * (q[0] + q[2]);
  const double oblong = std::abs(q[0] - q[2]) + std::abs(q[1]);
  if (focus() || !(std::abs(leading) > kSameValue) || oblong > kSameValue * std::abs(leading)) {
    return std::nullopt;
  }
  const Point middle = Point(l[0], l[1]) / (-2.0 * leading);
  const double square = std::norm(middle) - c / leading;
  return square > 0.0 ? std::optional(Circle{.centre = centre + length * middle,
                                             .radius = length * std::sqrt(square)})
                      : std::nullopt;
}

std::optional<PlaneLine> PlaneCubic::line() const {
  const double curved = std::abs(q[0]) + std::abs(q[1]) + std::abs(q[2]);
  const double size = std::hypot(l[0], l[1]);
  if (focus() || curved > kSameValue || !(size > kSameValue)) {
    return std::nullopt;
  }
  const Point across = Point(l[0], l[1]) / size;
  return PlaneLine{.normal = across, .offset = dot(across, centre) - length * c / size};
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
  result.c = square * along + quadratic(m) + dot(linear, m) + c;
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

}  // namespace kinestat
