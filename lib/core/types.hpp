// Names of the matrix types, and strong integers for ids. The only place that includes Eigen/Core.
#pragma once

#include <compare>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace kinestat {

using Vec3 = Eigen::Vector3d;
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6X = Eigen::Matrix<double, 6, Eigen::Dynamic>;
using MatX = Eigen::MatrixXd;
using MatXi = Eigen::MatrixXi;
using VecX = Eigen::VectorXd;

/// An index that does not mix with the indices of other things.
template <class Tag>
struct Id {
  int value = 0;

  friend auto operator<=>(const Id&, const Id&) = default;
};

using BodyId = Id<struct BodyTag>;
using CouplingId = Id<struct CouplingTag>;

}  // namespace kinestat
