// From seven homogeneous numbers to a dyad.
#pragma once

#include <optional>

#include "core/types.hpp"
#include "synthesis/dyad.hpp"
#include "synthesis/internal/condition_rows.hpp"

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

/// The smaller denominator among those that a dyad of this kind needs, as a share of the largest
/// of the seven numbers: its reciprocal is what their errors are multiplied by.
double smallest_denominator(const Eigen::Matrix<double, 7, 1>& x, DyadKind kind);

}  // namespace kinestat
