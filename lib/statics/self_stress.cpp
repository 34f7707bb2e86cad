#include "statics/self_stress.hpp"

#include "math/dense/readable_basis.hpp"

namespace kinestat {

std::vector<SelfStress> list_self_stresses(std::span<const VecX> vectors, const VecX& scales) {
  std::vector<SelfStress> list;
  if (vectors.size() * static_cast<std::size_t>(scales.size()) > kLongestList) {
    return list;
  }
  const MatX basis = readable_basis(rows_of(vectors, scales.size()), scales);
  for (Eigen::Index j = 0; j < basis.rows(); ++j) {
    SelfStress stress;
    for (int a = 0; a < basis.cols(); ++a) {
      if (basis(j, a) != 0.0) {
        stress.terms.push_back({.index = a, .coefficient = basis(j, a)});
      }
    }
    list.push_back(std::move(stress));
  }
  return list;
}

}  // namespace kinestat
