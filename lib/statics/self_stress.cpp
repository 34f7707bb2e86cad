#include "statics/self_stress.hpp"

#include <cmath>

#include "core/tolerance.hpp"
#include "math/echelon.hpp"

namespace kinestat {

namespace {

// Beyond this many coefficients a list is no help.
constexpr std::size_t kLongestList = 20000;

MatX as_rows(std::span<const VecX> vectors, const VecX& scales) {
  MatX rows(static_cast<Eigen::Index>(vectors.size()), scales.size());
  for (std::size_t j = 0; j < vectors.size(); ++j) {
    const VecX scaled = vectors[j].cwiseQuotient(scales);
    rows.row(static_cast<Eigen::Index>(j)) = scaled / scaled.cwiseAbs().maxCoeff();
  }
  return rows;
}

}  // namespace

std::vector<SelfStress> list_self_stresses(std::span<const VecX> vectors, const VecX& scales) {
  std::vector<SelfStress> list;
  if (vectors.empty() || vectors.size() * static_cast<std::size_t>(scales.size()) > kLongestList) {
    return list;
  }
  const Echelon echelon = find_echelon(as_rows(vectors, scales));
  for (std::size_t j = 0; j < echelon.pivot_columns.size(); ++j) {
    const VecX row = echelon.matrix.row(static_cast<Eigen::Index>(j));
    const double largest = row.cwiseAbs().maxCoeff();
    const double first = scales[echelon.pivot_columns[j]];
    SelfStress stress;
    for (int a = 0; a < row.size(); ++a) {
      if (std::abs(row[a]) > kRankZero * largest) {
        stress.terms.push_back({.index = a, .coefficient = row[a] * scales[a] / first});
      }
    }
    list.push_back(std::move(stress));
  }
  return list;
}

}  // namespace kinestat
