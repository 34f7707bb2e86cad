#include "studies/synthesis/positions/specification.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "core/synthesis_tolerance.hpp"
#include "core/tolerance.hpp"
#include "studies/synthesis/positions/special_frame.hpp"

namespace kinestat {

namespace {

// A circle point in polar coordinates of the special frame.
template <class Scalar>
struct PolarPoint {
  Scalar radius{1};
  Scalar sine{0};
  Scalar cosine{1};
};

template <class Scalar>
PolarPoint<Scalar> polar_of(const SpecialFrameOf<Scalar>& frame, const PointOf<Scalar>& point) {
  using std::abs;
  const PointOf<Scalar> local = frame.from_fixed(point);
  const Scalar radius = abs(local);
  return {.radius = radius, .sine = local.imag() / radius, .cosine = local.real() / radius};
}

// x of  x cos + y sin = right  at both points.
template <class Scalar>
PointOf<Scalar> solve_pair(const PolarPoint<Scalar>& e,
                           const PolarPoint<Scalar>& f,
                           const Scalar& right_e,
                           const Scalar& right_f) {
  const Scalar determinant = e.cosine * f.sine - e.sine * f.cosine;
  return {(right_e * f.sine - e.sine * right_f) / determinant,
          (e.cosine * right_f - right_e * f.cosine) / determinant};
}

// The cubic of stationary curvature through the point, cos / M + sin / N = sin cos / r; do Valle
// 1983, eq. 2.41 without its divisions.
template <class Scalar>
Scalar stationary_side(const PolarPoint<Scalar>& point) {
  return point.sine * point.cosine / point.radius;
}

// α4 cos + β4 sin of a Burmester point; do Valle 1983, eq. 2.53, with -3 d³/r², 4 α3 + 6 d and
// +3 d²/r where it prints +3, 3 and -3.
template <class Scalar>
Scalar burmester_side(const PolarPoint<Scalar>& point,
                      const Scalar& d,
                      const PointOf<Scalar>& third) {
  const Scalar a3 = third.real();
  const Scalar b3 = third.imag();
  const auto [r, s, c] = point;
  return -4.0 * b3 * c + (4.0 * a3 + 5.0 * d + 3.0 * d * d * d / (r * r)) * s -
         (4.0 * a3 + 6.0 * d) * (d / r) * s * s + 4.0 * b3 * (d / r) * s * c - 3.0 * d * d / r;
}

template <class Scalar>
class Specifier {
  using Point = PointOf<Scalar>;
  using Polar = PolarPoint<Scalar>;

 public:
  Specifier(const PositionSpecificationOf<Scalar>& given, const EffectiveFreedom* freedom)
      : given_(given), freedom_(freedom) {}

  SpecifiedPositionOf<Scalar> run() {
    if (!given_.pole) {
      return {.jets = PositionJetsOf<Scalar>{
                  .x = {given_.at.real()}, .y = {given_.at.imag()}, .angle = {given_.angle}}};
    }
    frame_.pole = *given_.pole;
    frame_.derivatives = {zero(), zero()};
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
  static Scalar length_of(const Point& point) {
    using std::abs;
    return abs(point);
  }

  static Scalar size_of(const Scalar& value) {
    using std::abs;
    return abs(value);
  }

  static Point zero() { return Point(Scalar(0), Scalar(0)); }

  // Euler and Savary with signed lengths from the pole: where the line of a point meets the
  // inflection circle, j = r r_O / (r_O - r), and for F j = r (1 - 1/m).
  SpecificationFault add_curvature(const CurvatureSpecificationOf<Scalar>& given) {
    const Point to_e = given_.at - frame_.pole;
    if (const SpecificationFault fault = check(given, to_e); fault != SpecificationFault::none) {
      return fault;
    }
    const Scalar r_e = length_of(to_e);
    const Point e = to_e / r_e;
    const Scalar r_o = dot(given.centre - frame_.pole, e);
    const Scalar j_e = r_e * r_o / (r_o - r_e);
    set_diameter(freedom_ != nullptr ? j_e * e + Scalar(freedom_->s) * left_of(e)
                                     : diameter_by_free_point(given, e, j_e));
    return SpecificationFault::none;
  }

  Point diameter_by_free_point(const CurvatureSpecificationOf<Scalar>& given,
                               const Point& e,
                               const Scalar& j_e) const {
    const Point to_f = given.free_point - frame_.pole;
    const Scalar r_f = length_of(to_f);
    const Scalar j_f = r_f * (1.0 - 1.0 / given.ratio);
    return solve_pair(Polar{.radius = Scalar(1), .sine = e.imag(), .cosine = e.real()},
                      Polar{.radius = r_f, .sine = to_f.imag() / r_f, .cosine = to_f.real() / r_f},
                      j_e,
                      j_f);
  }

  void set_diameter(const Point& diameter) {
    using std::atan2;
    frame_.diameter = length_of(diameter);
    frame_.angle =
        frame_.diameter > 0 ? Scalar(atan2(Scalar(-diameter.real()), diameter.imag())) : Scalar(0);
    frame_.derivatives.emplace_back(Scalar(0), frame_.diameter);
  }

  SpecificationFault check(const CurvatureSpecificationOf<Scalar>& given, const Point& to_e) const {
    using enum SpecificationFault;
    const Point arm = given.centre - given_.at;
    const Scalar size = std::max({length_of(given_.at), length_of(*given_.pole), length_of(to_e)});
    if (!(length_of(to_e) > kCancellation * size)) {
      return point_in_pole;
    }
    if (freedom_ == nullptr) {
      if (const SpecificationFault fault = check_free_point(given, to_e, size); fault != none) {
        return fault;
      }
    }
    if (!(length_of(arm) > kCancellation * size)) {
      return centre_in_point;
    }
    return size_of(cross(to_e, arm)) > kCollinearSpecification * length_of(to_e) * length_of(arm)
               ? centre_off_normal
               : none;
  }

  SpecificationFault check_free_point(const CurvatureSpecificationOf<Scalar>& given,
                                      const Point& to_e,
                                      const Scalar& size) const {
    using enum SpecificationFault;
    const Point to_f = given.free_point - frame_.pole;
    if (!(length_of(to_f) > kCancellation * size)) {
      return free_point_in_pole;
    }
    if (given.ratio == 0) {
      return zero_ratio;
    }
    return size_of(cross(to_e, to_f)) < kCollinearSpecification * length_of(to_e) * length_of(to_f)
               ? aligned_points
               : none;
  }

  SpecificationFault add_stationary() {
    KINESTAT_EXPECTS(given_.curvature.has_value());
    const Scalar d = frame_.diameter;
    const Polar e = polar_of(frame_, given_.at);
    if (!(d > kCancellation * e.radius)) {
      return SpecificationFault::no_inflection_circle;
    }
    const Polar f = polar_of(frame_, given_.curvature->free_point);
    const Point inverse = freedom_ != nullptr
                              ? on_line(e, stationary_side(e), Scalar(freedom_->tau / d))
                              : solve_pair(e, f, stationary_side(e), stationary_side(f));
    const Point third(3.0 * d * d * inverse.real() - 3.0 * d, 3.0 * d * d * inverse.imag());
    frame_.derivatives.push_back(third);
    if (given_.is_burmester) {
      const Scalar of_e = burmester_side(e, d, third);
      frame_.derivatives.push_back(freedom_ != nullptr
                                       ? on_line(e, of_e, Scalar(freedom_->tau_2 * d))
                                       : solve_pair(e, f, of_e, burmester_side(f, d, third)));
    }
    return SpecificationFault::none;
  }

  // x cos + y sin = right leaves a line; its point at a distance to the left of the normal.
  static Point on_line(const Polar& e, const Scalar& right, const Scalar& along) {
    const Point normal(e.cosine, e.sine);
    return right * normal + along * left_of(normal);
  }

  const PositionSpecificationOf<Scalar>& given_;
  const EffectiveFreedom* freedom_;  // instead of the free point; may be null
  SpecialFrameOf<Scalar> frame_;
};

}  // namespace

SpecifiedPosition find_jets(const PositionSpecification& specification) {
  return Specifier<double>(specification, nullptr).run();
}

SpecifiedPositionOf<BigFloat> find_precise_jets(
    const PositionSpecificationOf<BigFloat>& specification) {
  return Specifier<BigFloat>(specification, nullptr).run();
}

SpecifiedPosition find_jets(const PositionSpecification& specification,
                            const EffectiveFreedom& freedom) {
  return Specifier<double>(specification, &freedom).run();
}

}  // namespace kinestat
