#include "screw/coordinate_basis.hpp"

#include <array>

#include "math/orthonormal.hpp"

namespace kinestat {

namespace {

CoordinateBasis from_coordinates(std::vector<int> coordinates) {
  CoordinateBasis result;
  result.basis = Mat6X::Zero(6, static_cast<Eigen::Index>(coordinates.size()));
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    result.basis(coordinates[i], static_cast<Eigen::Index>(i)) = 1.0;
  }
  result.coordinates = std::move(coordinates);
  return result;
}

std::vector<int> nonzero_rows(const Mat6X& screws) {
  std::vector<int> rows;
  for (int r = 0; r < 6; ++r) {
    if (!screws.row(r).isZero(0.0)) {
      rows.push_back(r);
    }
  }
  return rows;
}

}  // namespace

CoordinateBasis find_minimal_basis(const Mat6X& screws, ScrewKind kind, double length) {
  if (screws.cols() == 0) {
    return from_coordinates({});  // Eigen must not take a row of nothing
  }
  std::vector<int> rows = nonzero_rows(screws);
  Vec6 scale = Vec6::Ones();
  scale.segment<3>(kind == ScrewKind::twist ? 3 : 0).setConstant(1.0 / length);
  const Mat6X scaled = scale.asDiagonal() * screws;
  const MatX span = orthonormal_range(scaled);
  if (span.cols() == static_cast<Eigen::Index>(rows.size())) {
    return from_coordinates(std::move(rows));
  }
  CoordinateBasis result;
  const Mat6X in_metres = scale.cwiseInverse().asDiagonal() * span;
  result.basis = orthonormal_range(in_metres);
  return result;
}

CoordinateBasis planar_basis() {
  return from_coordinates({2, 3, 4});
}

CoordinateBasis spatial_basis() {
  return from_coordinates({0, 1, 2, 3, 4, 5});
}

std::vector<std::string> row_names(const CoordinateBasis& basis, ScrewKind kind) {
  constexpr std::array<const char*, 6> kTwist = {"wx", "wy", "wz", "vx", "vy", "vz"};
  constexpr std::array<const char*, 6> kWrench = {"Tx", "Ty", "Tz", "Fx", "Fy", "Fz"};
  std::vector<std::string> names;
  for (int i = 0; i < basis.order(); ++i) {
    if (basis.is_made_of_coordinates()) {
      const auto row = static_cast<std::size_t>(basis.coordinates[static_cast<std::size_t>(i)]);
      names.emplace_back(kind == ScrewKind::twist ? kTwist[row] : kWrench[row]);
    } else {
      names.push_back("s" + std::to_string(i + 1));
    }
  }
  return names;
}

}  // namespace kinestat
