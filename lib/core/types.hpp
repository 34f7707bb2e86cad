// Names of the matrix types, and strong integers for ids. The only place that includes Eigen/Core.
#pragma once

#include <compare>
#include <type_traits>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace kinestat {

template <class Scalar>
using Vec3Of = Eigen::Matrix<Scalar, 3, 1>;
template <class Scalar>
using Vec6Of = Eigen::Matrix<Scalar, 6, 1>;

/// A parameter that takes any expression of vectors; the type of number comes from elsewhere.
template <class Scalar>
using Vec3In = std::type_identity_t<Vec3Of<Scalar>>;

using Vec3 = Vec3Of<double>;
using Vec6 = Vec6Of<double>;
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
