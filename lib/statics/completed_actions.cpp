#include "statics/completed_actions.hpp"

#include <utility>

#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "math/dense/least_squares.hpp"

namespace kinestat {

namespace {

// What least squares weigh the magnitudes in their scales with: 1, or for elastic actions what
// makes the sum of squares twice the complementary energy.
VecX weights_of(const Mechanism& mechanism, const VecX& scales) {
  if (mechanism.indeterminate == IndeterminateChoice::minimum_norm) {
    return VecX::Ones(scales.size());
  }
  const Eigen::Map<const VecX> compliances(mechanism.compliances.data(), scales.size());
  return compliances.cwiseSqrt().cwiseProduct(scales);
}

// The self-stresses in columns, in their scales, the largest entry 1 and what is rounding beside it
// zero.
MatX scaled_columns(const std::vector<VecX>& stresses, const VecX& scales) {
  MatX columns(scales.size(), static_cast<Eigen::Index>(stresses.size()));
  for (std::size_t j = 0; j < stresses.size(); ++j) {
    const VecX scaled = stresses[j].cwiseQuotient(scales);
    const double largest = scaled.cwiseAbs().maxCoeff();
    columns.col(static_cast<Eigen::Index>(j)) =
        (scaled.array().abs() <= kRankZero * largest).select(0.0, scaled / largest);
  }
  return columns;
}

}  // namespace

CompletedActions find_completed_actions(const Mechanism& mechanism,
                                        const VecX& particular,
                                        const std::vector<VecX>& stresses) {
  KINESTAT_EXPECTS(mechanism.indeterminate != IndeterminateChoice::report);
  const VecX scales = action_scales(mechanism);
  LeastSquares least = find_least_squares(scaled_columns(stresses, scales),
                                          particular.cwiseQuotient(scales),
                                          weights_of(mechanism, scales));
  return {.magnitudes = least.values.cwiseProduct(scales),
          .is_open = std::move(least.is_open),
          .measured = scales.asDiagonal() * least.measured,
          .open = scales.asDiagonal() * least.open};
}

VecX action_scales(const Mechanism& mechanism) {
  VecX scales(mechanism.topology.action_count());
  for (Eigen::Index a = 0; a < scales.size(); ++a) {
    const bool is_couple = mechanism.topology.actions[static_cast<std::size_t>(a)].is_couple;
    scales[a] = is_couple ? mechanism.geometry.length : 1.0;
  }
  return scales;
}

}  // namespace kinestat
