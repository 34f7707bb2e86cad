#include "synthesis/specification.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "synthesis/special_frame.hpp"

namespace kinestat {

namespace {

// A circle point in polar coordinates of the special frame.
struct PolarPoint {
  double radius = 1.0;
  double sine = 0.0;
  double cosine = 1.0;
};

PolarPoint polar_of(const SpecialFrame& frame, const Point& point) {
  const Point local = frame.from_fixed(point);
  const double radius = std::abs(local);
  return {.radius = radius, .sine = local.imag() / radius, .cosine = local.real() / radius};
}

// x of  x cos + y sin = right  at both points.
Point solve_pair(const PolarPoint& e, const PolarPoint& f, double right_e, double right_f) {
  const double determinant = e.cosine * f.sine - e.sine * f.cosine;
  return {(right_e * f.sine - e.sine * right_f) / determinant,
          (e.cosine * right_f - right_e * f.cosine) / determinant};
}

// The cubic of stationary curvature through the point, cos / M + sin / N = sin cos / r; do Valle
// 1983, eq. 2.41 without its divisions.
double stationary_side(const PolarPoint& point) {
  return point.sine * point.cosine / point.radius;
}

// α4 cos + β4 sin of a Burmester point; do Valle 1983, eq. 2.53, with -3 d³/r², 4 α3 + 6 d and
// +3 d²/r where it prints +3, 3 and -3.
double burmester_side(const PolarPoint& point, double d, const Point& third) {
  const double a3 = third.real();
  const double b3 = third.imag();
  const auto [r, s, c] = point;
  return -4.0 * b3 * c + (4.0 * a3 + 5.0 * d + 3.0 * d * d * d / (r * r)) * s -
         (4.0 * a3 + 6.0 * d) * (d / r) * s * s + 4.0 * b3 * (d / r) * s * c - 3.0 * d * d / r;
}

class Specifier {
 public:
  explicit Specifier(const PositionSpecification& given) : given_(given) {}

  SpecifiedPosition run() {
    if (!given_.pole) {
      return {.jets = finite_position(given_.at, given_.angle)};
    }
    frame_.pole = *given_.pole;
    frame_.derivatives = {Point(0.0, 0.0), Point(0.0, 0.0)};
    SpecificationFault fault = SpecificationFault::none;
    if (given_.curvature) {
      fault = add_curvature(*given_.curvature);
    }
    if (fault == SpecificationFault::none && given_.is_stationary) {
      fault = add_stationary();
    }
    if (fault != SpecificationFault::none) {
      return {.jets = std::nullopt, .fault = fault};
    }
    return {.jets = jets_of(frame_, given_.at, given_.angle)};
  }

 private:
  // Euler and Savary with signed lengths from the pole: where the line of a point meets the
  // inflection circle, j = r r_O / (r_O - r), and for F j = r (1 - 1/m).
  SpecificationFault add_curvature(const CurvatureSpecification& given) {
    using enum SpecificationFault;
    const Point to_e = given_.at - frame_.pole;
    const Point to_f = given.free_point - frame_.pole;
    const Point to_centre = given.centre - frame_.pole;
    const double r_e = std::abs(to_e);
    const double r_f = std::abs(to_f);
    if (const SpecificationFault fault = check(given, to_e, to_f); fault != none) {
      return fault;
    }
    const double r_o = dot(to_centre, to_e) / r_e;
    const double j_e = r_e * r_o / (r_o - r_e);
    const double j_f = r_f * (1.0 - 1.0 / given.ratio);
    const PolarPoint e{.radius = r_e, .sine = to_e.imag() / r_e, .cosine = to_e.real() / r_e};
    const PolarPoint f{.radius = r_f, .sine = to_f.imag() / r_f, .cosine = to_f.real() / r_f};
    const Point diameter = solve_pair(e, f, j_e, j_f);
    frame_.diameter = std::abs(diameter);
    frame_.angle = frame_.diameter > 0.0 ? std::atan2(-diameter.real(), diameter.imag()) : 0.0;
    frame_.derivatives.emplace_back(0.0, frame_.diameter);
    return none;
  }

  SpecificationFault check(const CurvatureSpecification& given,
                           const Point& to_e,
                           const Point& to_f) const {
    using enum SpecificationFault;
    const Point arm = given.centre - given_.at;
    const double size = std::max({std::abs(given_.at), std::abs(*given_.pole), std::abs(to_e)});
    if (!(std::abs(to_e) > kCancellation * size)) {
      return point_in_pole;
    }
    if (!(std::abs(to_f) > kCancellation * size)) {
      return free_point_in_pole;
    }
    if (!(std::abs(arm) > kCancellation * size)) {
      return centre_in_point;
    }
    if (given.ratio == 0.0) {
      return zero_ratio;
    }
    if (std::abs(cross(to_e, to_f)) < kCollinearSpecification * std::abs(to_e) * std::abs(to_f)) {
      return aligned_points;
    }
    return std::abs(cross(to_e, arm)) > kCollinearSpecification * std::abs(to_e) * std::abs(arm)
               ? centre_off_normal
               : none;
  }

  SpecificationFault add_stationary() {
    KINESTAT_EXPECTS(given_.curvature.has_value());
    const double d = frame_.diameter;
    const PolarPoint e = polar_of(frame_, given_.at);
    const PolarPoint f = polar_of(frame_, given_.curvature->free_point);
    if (!(d > kCancellation * e.radius)) {
      return SpecificationFault::no_inflection_circle;
    }
    const Point inverse = solve_pair(e, f, stationary_side(e), stationary_side(f));
    const Point third(3.0 * d * d * inverse.real() - 3.0 * d, 3.0 * d * d * inverse.imag());
    frame_.derivatives.push_back(third);
    if (given_.is_burmester) {
      frame_.derivatives.push_back(
          solve_pair(e, f, burmester_side(e, d, third), burmester_side(f, d, third)));
    }
    return SpecificationFault::none;
  }

  const PositionSpecification& given_;
  SpecialFrame frame_;
};

}  // namespace

SpecifiedPosition find_jets(const PositionSpecification& specification) {
  return Specifier(specification).run();
}

}  // namespace kinestat
