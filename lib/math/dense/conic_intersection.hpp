// The points that two conics of the projective plane share.
#pragma once

#include <complex>
#include <vector>

#include "core/types.hpp"

namespace kinestat {

using Mat3 = Eigen::Matrix3d;

/// One shared point in homogeneous coordinates.
struct ConicPoint {
  Eigen::Vector3cd y;    ///< of length 1; its largest coordinate is real and positive
  bool is_real = false;  ///< then the imaginary parts are zero
  int multiplicity = 1;
  double condition = 1.0;  ///< errors of the conics, of size 1, times this are errors of the point
};

enum class SharedPart { none, line, conic };

struct ConicIntersection {
  std::vector<ConicPoint> points;  ///< those outside the shared part; four if there is none
  SharedPart shared = SharedPart::none;
  Vec3 shared_line = Vec3::Zero();  ///< of length 1: points y with line . y = 0
};

/// The conics are yᵀ a y = 0 and yᵀ b y = 0 with symmetric matrices. By Bézout four points,
/// counted with multiplicity. Method: the null space of the cubics that are multiples of the
/// conics holds the cubic monomials of the points (Macaulay); multiplication by a ratio of two
/// linear forms acts on it, and its eigenvectors are the points; then Newton.
ConicIntersection intersect_conics(const Mat3& a, const Mat3& b);

}  // namespace kinestat
