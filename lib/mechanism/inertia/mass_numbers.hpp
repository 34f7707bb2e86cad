// Mass and inertia of a body, for any type of number.
#pragma once

#include <optional>
#include <span>

#include "core/types.hpp"

namespace kinestat {

template <class Scalar>
using Mat3Of = Eigen::Matrix<Scalar, 3, 3>;

/// Mass and inertia as in BodyMass, but for all planets together if a body stands for several.
template <class Scalar>
struct MassNumbersOf {
  Scalar mass = Scalar(0.0);
  Vec3Of<Scalar> centre = Vec3Of<Scalar>::Zero();
  Mat3Of<Scalar> tensor = Mat3Of<Scalar>::Zero();  ///< about the centre
};

/// The tensor that the numbers of the key `inertia` give: one is the moment about the unit vector
/// `axis`, or about z without an axis; three are the moments about the axes of the world; nine are
/// the entries row by row.
template <class Scalar>
Mat3Of<Scalar> inertia_tensor(std::span<const Scalar> entries,
                              const std::optional<Vec3Of<Scalar>>& axis) {
  Mat3Of<Scalar> tensor = Mat3Of<Scalar>::Zero();
  if (entries.size() == 1 && !axis) {
    tensor(2, 2) = entries.front();
    return tensor;
  }
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index j = 0; j < 3; ++j) {
      const auto row = static_cast<std::size_t>(i);
      const auto column = static_cast<std::size_t>(j);
      if (entries.size() == 1) {
        tensor(i, j) = entries.front() * (*axis)[i] * (*axis)[j];
      } else if (entries.size() == 9) {
        tensor(i, j) = entries[3 * row + column];
      } else if (i == j) {
        tensor(i, j) = entries[row];
      }
    }
  }
  return tensor;
}

}  // namespace kinestat
