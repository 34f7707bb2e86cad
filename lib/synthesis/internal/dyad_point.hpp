// From seven homogeneous numbers to a dyad.
#pragma once

#include <optional>

#include "core/types.hpp"
#include "synthesis/dyad.hpp"
#include "synthesis/internal/condition_rows.hpp"

namespace kinestat {

/// (u, v, a, b, p, q, h), of any length. Finite points are divided by whichever of their two
/// denominators is larger, which stays accurate far away. Empty if circle point and centre both
/// lie at infinity, where every point would do.
std::optional<Dyad> dyad_of(const Eigen::Matrix<double, 7, 1>& x,
                            const ConditionRows& system,
                            const PositionJets& first);

/// The smaller denominator among those that a dyad of this kind needs, as a share of the largest
/// of the seven numbers: its reciprocal is what their errors are multiplied by.
double smallest_denominator(const Eigen::Matrix<double, 7, 1>& x, DyadKind kind);

}  // namespace kinestat
