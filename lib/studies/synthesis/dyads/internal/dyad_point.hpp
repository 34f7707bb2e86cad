// From seven homogeneous numbers to a dyad.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "core/types.hpp"
#include "studies/synthesis/dyads/dyad.hpp"
#include "studies/synthesis/dyads/internal/condition_rows.hpp"
#include "studies/synthesis/dyads/internal/precise_null_space.hpp"

namespace kinestat {

/// (u, v, a, b, p, q, h), of any length. Finite points are divided by whichever of their two
/// denominators is larger, which stays accurate far away. `error` is what the positions leave
/// uncertain of the seven numbers, the largest of which counts as 1: a point whose reciprocal
/// distance is not larger lies at infinity, and a dyad of four conditions is improved as such.
/// Empty if circle point and centre both lie at infinity, where every point would do; where the
/// error alone puts them there, the crank of what is left of them.
std::optional<Dyad> dyad_of(const Eigen::Matrix<double, 7, 1>& x,
                            const ConditionRows& system,
                            const PositionJets& first,
                            double error);

/// Conditions with all their digits, and what a change of a position by a unit of length does to
/// each.
struct StraightConditions {
  std::vector<PreciseRow> rows;
  std::vector<double> slopes;
  std::vector<double> noise;
  double radius = 1.0;  ///< of the positions, in units of the system
};

template <class Scalar>
StraightConditions straight_conditions(const ConditionRowsOf<Scalar>& system) {
  StraightConditions result{
      .rows = {}, .slopes = system.slopes, .noise = system.noise, .radius = system.radius};
  for (const std::array<Scalar, 7>& row : system.rows) {
    PreciseRow& precise = result.rows.emplace_back();
    std::ranges::copy(row, precise.begin());
  }
  return result;
}

/// Instead of a very long crank the slider, or inverted slider, that misses the positions by no
/// more than half a unit of their last decimal explains: that with the least sum of squares. Empty
/// if there is none. Its digits are those that the decimals leave. The residual is not set.
std::optional<Dyad> find_straight(const Eigen::Matrix<double, 7, 1>& x,
                                  const StraightConditions& conditions,
                                  const LastDecimal& decimal,
                                  const ConditionRows& system,
                                  const PositionJets& first);

/// The smaller denominator among those that a dyad of this kind needs, as a share of the largest
/// of the seven numbers: its reciprocal is what their errors are multiplied by.
double smallest_denominator(const Eigen::Matrix<double, 7, 1>& x, DyadKind kind);

}  // namespace kinestat
