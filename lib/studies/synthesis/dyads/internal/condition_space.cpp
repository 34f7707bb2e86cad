#include "studies/synthesis/dyads/internal/condition_space.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/synthesis_tolerance.hpp"
#include "core/tolerance.hpp"

namespace kinestat {

namespace {

MatX matrix_of(const ConditionRows& system) {
  MatX matrix(static_cast<Eigen::Index>(system.rows.size()), 7);
  for (std::size_t i = 0; i < system.rows.size(); ++i) {
    for (std::size_t j = 0; j < 7; ++j) {
      matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = system.rows[i][j];
    }
  }
  return matrix;
}

// Every singular value clearly counts or is rounding.
bool has_clear_gap(const VecX& values) {
  return std::ranges::all_of(values, [&](double value) {
    return value > kClearGap * values[0] || value < kCancellation * values[0];
  });
}

void find_why_flat(const ConditionRows& system,
                   std::span<const PositionJets> positions,
                   ConditionSpace& space) {
  const Degeneracy reason = find_degeneracy(positions);
  const bool is_noisy =
      std::ranges::any_of(system.noise, [](double noise) { return noise > kNoisyRow; });
  space.status = BurmesterStatus::family;
  if (reason == Degeneracy::repeated_position) {
    space.reason = reason;
  } else if (is_noisy || !has_clear_gap(space.space.singular_values)) {
    space.status = BurmesterStatus::no_digits;
  } else {
    space.reason = reason == Degeneracy::none ? Degeneracy::dependent : reason;
  }
}

}  // namespace

double find_loss(const NullSpace& space, const std::vector<double>& noise) {
  double loss = kEpsilon;
  for (std::size_t i = 0; i < noise.size(); ++i) {
    loss += noise[i] * space.inverse.col(static_cast<Eigen::Index>(i)).norm();
  }
  return loss;
}

double digits_of(double loss) {
  constexpr double kMost = 16.0;
  return std::isnan(loss) ? 0.0 : std::clamp(-std::log10(loss), 0.0, kMost);
}

ConditionSpace find_condition_space(const ConditionRows& system,
                                    std::span<const PositionJets> positions) {
  ConditionSpace result;
  result.space = find_null_space(matrix_of(system));
  result.loss = find_loss(result.space, system.noise);
  result.digits = digits_of(result.loss);
  result.reciprocal_condition = result.space.reciprocal_condition();
  if (!(result.loss < kUselessLoss)) {
    find_why_flat(system, positions, result);
  }
  return result;
}

}  // namespace kinestat
