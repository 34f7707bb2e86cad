// Frames in space, for plain numbers and for numbers that move.
#pragma once

#include <cmath>

#include "screw/pose.hpp"
#include "studies/motion/internal/jet.hpp"

namespace kinestat {

/// What closure needs of space. Screws are [ω; v], wrenches [T; F].
struct SpatialFrames {
  static constexpr int kScrew = 6;
  static constexpr int kDirections = 3;
  template <class S>
  using Vector = Eigen::Matrix<S, 3, 1>;
  template <class S>
  using Screw = Eigen::Matrix<S, 6, 1>;
  template <class S>
  using Matrix = Eigen::Matrix<S, 3, 3>;

  template <class S>
  struct Frame {
    Matrix<S> rotation = Matrix<S>::Identity();
    Vector<S> shift = Vector<S>::Zero();

    Vector<S> direction(const Vec3& d) const {
      Vector<S> result;
      for (int i = 0; i < 3; ++i) {
        result[i] = rotation(i, 0) * S(d[0]) + rotation(i, 1) * S(d[1]) + rotation(i, 2) * S(d[2]);
      }
      return result;
    }

    Vector<S> point(const Vec3& p) const { return direction(p) + shift; }
  };

  static Vec3 vector(const Vec3& v) { return v; }

  /// Rodrigues' formula, row by row.
  template <class S>
  static Matrix<S> rotation(const Vec3& a, const S& angle) {
    using std::cos, std::sin;
    const S c = cos(angle);
    const S s = sin(angle);
    const S u = S(1.0) - c;
    Matrix<S> result;
    result << c + u * S(a[0] * a[0]), u * S(a[0] * a[1]) - s * S(a[2]),
        u * S(a[0] * a[2]) + s * S(a[1]), u * S(a[0] * a[1]) + s * S(a[2]), c + u * S(a[1] * a[1]),
        u * S(a[1] * a[2]) - s * S(a[0]), u * S(a[0] * a[2]) - s * S(a[1]),
        u * S(a[1] * a[2]) + s * S(a[0]), c + u * S(a[2] * a[2]);
    return result;
  }

  template <class S>
  static Frame<S> rolled(const Frame<S>& f, const Matrix<S>& turn, const Vec3& centre) {
    Frame<S> result;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        result.rotation(i, j) = f.rotation(i, 0) * turn(0, j) + f.rotation(i, 1) * turn(1, j) +
                                f.rotation(i, 2) * turn(2, j);
      }
    }
    result.shift = f.point(centre) - result.direction(centre);
    return result;
  }

  template <class S>
  static Frame<S> turned(
      const Frame<S>& f, const Vec3& axis, const Vec3& centre, double pitch, const S& angle) {
    Frame<S> result = rolled(f, rotation(axis, angle), centre);
    if (pitch != 0.0) {
      const Vector<S> d = f.direction(axis);
      for (int i = 0; i < 3; ++i) {
        result.shift[i] += d[i] * angle * S(pitch);
      }
    }
    return result;
  }

  template <class S>
  static Frame<S> shifted(const Frame<S>& f, const Vec3& direction, const S& distance) {
    Frame<S> result = f;
    const Vector<S> d = f.direction(direction);
    for (int i = 0; i < 3; ++i) {
      result.shift[i] += d[i] * distance;
    }
    return result;
  }

  template <class S>
  static Screw<S> turn_screw(const Frame<S>& f, const Vec3& axis, const Vec3& at, double pitch) {
    const Vector<S> a = f.direction(axis);
    Screw<S> result;
    result << a, f.point(at).cross(a) + S(pitch) * a;
    return result;
  }

  template <class S>
  static Screw<S> slide_screw(const Frame<S>& f, const Vec3& direction) {
    Screw<S> result;
    result << Vector<S>(Vector<S>::Zero()), f.direction(direction);
    return result;
  }

  template <class S>
  static Screw<S> force(const Vector<S>& d, const Vector<S>& at) {
    Screw<S> result;
    result << at.cross(d), d;
    return result;
  }

  template <class S>
  static Screw<S> couple_across(const Vector<S>& head, const Vector<S>& tail) {
    return couple<S>(head.cross(tail));
  }

  template <class S>
  static Screw<S> couple(const Vector<S>& moment) {
    Screw<S> result;
    result << moment, Vector<S>(Vector<S>::Zero());
    return result;
  }

  static BodyPose pose(const Frame<double>& f) {
    return {.rotation = f.rotation, .shift = f.shift};
  }

  /// About the unit vector `axis`, from u to v.
  template <class S>
  static S angle(const Vector<S>& axis, const Vector<S>& u, const Vector<S>& v) {
    using std::atan2;
    const S along_u = axis[0] * u[0] + axis[1] * u[1] + axis[2] * u[2];
    const S along_v = axis[0] * v[0] + axis[1] * v[1] + axis[2] * v[2];
    const S cosine = u[0] * v[0] + u[1] * v[1] + u[2] * v[2] - along_u * along_v;
    const S sine = axis[0] * (u[1] * v[2] - u[2] * v[1]) + axis[1] * (u[2] * v[0] - u[0] * v[2]) +
                   axis[2] * (u[0] * v[1] - u[1] * v[0]);
    return atan2(sine, cosine);
  }
};

}  // namespace kinestat
