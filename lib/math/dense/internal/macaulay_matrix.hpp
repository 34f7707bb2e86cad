// The cubics that are multiples of two conics, and where they lead to.
#pragma once

#include <complex>
#include <vector>

#include "core/types.hpp"

namespace kinestat {

/// How far a point of length 1 is from lying on both conics yᵀ a y = 0 and yᵀ b y = 0 of size 1.
double conic_miss(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b, const Eigen::Vector3cd& y);

/// The 6 x 10 matrix of the two conics times x, y and z, by the monomials of third degree. Its null
/// space holds the monomials of the points that the conics share, four unless they share a line.
class MacaulayMatrix {
 public:
  MacaulayMatrix(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b);

  /// Smallest by largest singular value: rounding if the conics share a line.
  double gap() const { return gap_; }

  /// The four shared points, each of length 1, as good as the eigenvectors of a 4 x 4 matrix are.
  /// Only if the gap is none of rounding.
  std::vector<Eigen::Vector3cd> rough_points() const;

 private:
  double worst_miss(const std::vector<Eigen::Vector3cd>& points) const;

  Eigen::Matrix3d a_;
  Eigen::Matrix3d b_;
  Eigen::Matrix<double, 10, 4> cubics_;  // the null space
  double gap_ = 0.0;
};

}  // namespace kinestat
