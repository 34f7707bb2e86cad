#include "screw/coordinate_basis.hpp"

#include <array>
#include <cmath>

#include "core/tolerance.hpp"
#include "math/dense/span.hpp"

namespace kinestat {

namespace {

// The size of a mechanism as a power of two: numbers in this unit are not rounded.
Vec6 units_for(ScrewKind kind, double length) {
  Vec6 unit = Vec6::Ones();
  const double power = std::exp2(std::round(std::log2(length)));
  unit.segment<3>(kind == ScrewKind::twist ? 3 : 0).setConstant(power);
  return unit;
}

CoordinateBasis from_coordinates(std::vector<int> coordinates, const Vec6& unit) {
  CoordinateBasis result;
  result.basis = Mat6X::Zero(6, static_cast<Eigen::Index>(coordinates.size()));
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    result.basis(coordinates[i], static_cast<Eigen::Index>(i)) = 1.0;
  }
  result.coordinates = std::move(coordinates);
  result.unit = unit;
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

// Screws in these units. What has no length, a translation or a couple, counts as one of them,
// however large or small the mechanism: beside it nothing else counts as zero.
Mat6X in_units(const Mat6X& screws, ScrewKind kind, const Vec6& unit) {
  Mat6X result = unit.cwiseInverse().asDiagonal() * screws;
  const Eigen::Index direction = kind == ScrewKind::twist ? 0 : 3;
  const Eigen::Index other = 3 - direction;
  for (Eigen::Index c = 0; c < result.cols(); ++c) {
    if (screws.col(c).segment<3>(direction).isZero(0.0)) {
      result.col(c) *= unit[other];
    }
  }
  return result;
}

// Whether the columns surely span everything: as many of them as there are rows stand out from
// those before by a tenth of the longest. Then no pivot of `orthonormal_range` is less than 1e-7 of
// its first, far above what counts as zero.
bool surely_span_all(const MatX& columns) {
  constexpr double kStandsOut = 0.1;
  const double least = kStandsOut * columns.colwise().norm().maxCoeff();
  Eigen::Matrix<double, 6, 6> basis;
  Vec6 rest = Vec6::Zero();
  const Eigen::Index rows = columns.rows();
  Eigen::Index rank = 0;
  for (Eigen::Index c = 0; c < columns.cols() && rank < rows; ++c) {
    rest.head(rows) = columns.col(c);
    for (Eigen::Index k = 0; k < rank; ++k) {
      rest -= rest.dot(basis.col(k)) * basis.col(k);
    }
    const double norm = rest.norm();
    if (norm > least) {
      basis.col(rank++) = rest / norm;
    }
  }
  return rank == rows;
}

}  // namespace

bool CoordinateBasis::holds(const Vec6& screw) const {
  const Vec6 whole = screw.cwiseQuotient(unit);
  const Vec6 rest = whole - basis * (basis.transpose() * whole);
  return !(rest.norm() > kRankZero * whole.norm());
}

CoordinateBasis find_minimal_basis(const Mat6X& screws, ScrewKind kind, double length) {
  const Vec6 unit = units_for(kind, length);
  if (screws.cols() == 0) {
    return from_coordinates({}, unit);  // Eigen must not take a row of nothing
  }
  std::vector<int> rows = nonzero_rows(screws);
  const MatX columns = in_units(screws, kind, unit)(rows, Eigen::all);
  if (surely_span_all(columns)) {
    return from_coordinates(std::move(rows), unit);
  }
  const MatX span = orthonormal_range(columns);
  if (span.cols() == span.rows()) {
    return from_coordinates(std::move(rows), unit);
  }
  CoordinateBasis result;
  result.basis = Mat6X::Zero(6, span.cols());
  result.basis(rows, Eigen::all) = span;
  result.unit = unit;
  return result;
}

CoordinateBasis planar_basis(ScrewKind kind, double length) {
  return from_coordinates({2, 3, 4}, units_for(kind, length));
}

CoordinateBasis spatial_basis(ScrewKind kind, double length) {
  return from_coordinates({0, 1, 2, 3, 4, 5}, units_for(kind, length));
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
