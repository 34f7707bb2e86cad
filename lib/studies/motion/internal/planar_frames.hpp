// Frames in the plane, for plain numbers and for numbers that move.
#pragma once

#include <cmath>

#include "screw/pose.hpp"
#include "studies/motion/internal/jet.hpp"

namespace kinestat {

/// What closure needs of the plane. Screws are [ω; vx, vy], wrenches [T; Fx, Fy].
struct PlanarFrames {
  static constexpr int kScrew = 3;
  static constexpr int kDirections = 2;
  template <class S>
  using Vector = Eigen::Matrix<S, 2, 1>;
  template <class S>
  using Screw = Eigen::Matrix<S, 3, 1>;

  template <class S>
  struct Frame {
    S c = 1.0;
    S s = 0.0;
    Vector<S> shift = Vector<S>(S(0.0), S(0.0));

    Vector<S> direction(const Vector<double>& d) const {
      return Vector<S>(c * S(d[0]) - s * S(d[1]), s * S(d[0]) + c * S(d[1]));
    }

    Vector<S> point(const Vector<double>& p) const { return direction(p) + shift; }
  };

  static Vector<double> vector(const Vec3& v) { return v.head<2>(); }

  /// The axis is z or -z.
  template <class S>
  static Frame<S> turned(
      const Frame<S>& f, const Vec3& axis, const Vec3& centre, double /*pitch*/, const S& angle) {
    using std::cos, std::sin;
    const S c = cos(angle);
    const S s = axis[2] * sin(angle);
    Frame<S> result;
    result.c = f.c * c - f.s * s;
    result.s = f.s * c + f.c * s;
    // The centre keeps its place.
    const S x = centre[0];
    const S y = centre[1];
    result.shift[0] = f.shift[0] + (f.c - result.c) * x - (f.s - result.s) * y;
    result.shift[1] = f.shift[1] + (f.s - result.s) * x + (f.c - result.c) * y;
    return result;
  }

  template <class S>
  static Frame<S> shifted(const Frame<S>& f, const Vec3& direction, const S& distance) {
    Frame<S> result = f;
    const Vector<S> d = f.direction(vector(direction));
    result.shift[0] += d[0] * distance;
    result.shift[1] += d[1] * distance;
    return result;
  }

  template <class S>
  static Frame<S> rolled(const Frame<S>& f, const Eigen::Matrix<S, 3, 3>&, const Vec3&) {
    return f;  // there are no balls in the plane
  }

  template <class S>
  static Screw<S> turn_screw(const Frame<S>& f, const Vec3& axis, const Vec3& at, double) {
    const Vector<S> p = f.point(vector(at));
    const S sense = axis[2];
    return {sense, sense * p[1], -(sense * p[0])};
  }

  template <class S>
  static Screw<S> slide_screw(const Frame<S>& f, const Vec3& direction) {
    const Vector<S> d = f.direction(vector(direction));
    return {S(0.0), d[0], d[1]};
  }

  template <class S>
  static Screw<S> force(const Vector<S>& d, const Vector<S>& at) {
    return {at[0] * d[1] - at[1] * d[0], d[0], d[1]};
  }

  template <class S>
  static Screw<S> couple_across(const Vector<S>& head, const Vector<S>& tail) {
    return {head[0] * tail[1] - head[1] * tail[0], S(0.0), S(0.0)};
  }

  template <class S>
  static Screw<S> couple(const Vector<S>&) {
    return {S(1.0), S(0.0), S(0.0)};  // of a unit moment: there is but one axis
  }

  static BodyPose pose(const Frame<double>& f) {
    BodyPose result;
    result.rotation.topLeftCorner<2, 2>() << f.c, -f.s, f.s, f.c;
    result.shift = {f.shift[0], f.shift[1], 0.0};
    return result;
  }

  /// Angle about z or the axis, from u to v.
  template <class S>
  static S angle(const Vector<S>&, const Vector<S>& u, const Vector<S>& v) {
    using std::atan2;
    return atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]);
  }
};

}  // namespace kinestat
