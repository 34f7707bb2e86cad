// Turns: of balls, and counted beyond a full one.
#pragma once

#include <cmath>
#include <numbers>

#include "screw/pose.hpp"
#include "studies/motion/internal/jet.hpp"

namespace kinestat {

/// The full turns added that bring `angle` next to `near`.
inline double counted_turn(double angle, double near) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  return angle + kTurn * std::round((near - angle) / kTurn);
}

inline Jet counted_turn(Jet angle, double near) {
  angle.value = counted_turn(angle.value, near);
  return angle;
}

/// The turn of a ball.
inline Mat3 rotation_of(const double* q) {
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
}

inline Mat3 cross_matrix(const Vec3& w) {
  Mat3 result;
  result << 0.0, -w[2], w[1], w[2], 0.0, -w[0], -w[1], w[0], 0.0;
  return result;
}

// A turn that begins as R and has the angular velocity w and its derivative a.
inline Eigen::Matrix<Jet, 3, 3> moving_rotation(const Mat3& R, const Vec3& w, const Vec3& a) {
  const Mat3 W = cross_matrix(w);
  const Mat3 first = W * R;
  const Mat3 second = cross_matrix(a) * R + W * first;
  Eigen::Matrix<Jet, 3, 3> result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      result(i, j) = Jet(R(i, j), first(i, j), second(i, j));
    }
  }
  return result;
}

template <class Matrix>
Matrix transposed(const Matrix& m) {
  Matrix result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      result(i, j) = m(j, i);
    }
  }
  return result;
}

}  // namespace kinestat
