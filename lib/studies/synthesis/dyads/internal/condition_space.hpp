// What the conditions of a task leave open, and what rounding of the positions leaves of it.
#pragma once

#include <span>
#include <vector>

#include "math/dense/null_space.hpp"
#include "studies/synthesis/dyads/burmester.hpp"
#include "studies/synthesis/dyads/internal/condition_rows.hpp"

namespace kinestat {

struct ConditionSpace {
  NullSpace space;
  BurmesterStatus status = BurmesterStatus::solved;
  Degeneracy reason = Degeneracy::none;
  double loss = 0.0;  ///< what rounding of the positions moves the null space by
  double digits = 0.0;
  double reciprocal_condition = 0.0;
};

/// Tells positions that depend on each other from positions that are too close: the former leave a
/// clear gap in the singular values and rounding far below, the latter neither.
ConditionSpace find_condition_space(const ConditionRows& system,
                                    std::span<const PositionJets> positions);

/// What rounding of the rows, each by its noise, moves their null space by.
double find_loss(const NullSpace& space, const std::vector<double>& noise);

/// Decimal digits that an error leaves, 0 to 16.
double digits_of(double loss);

}  // namespace kinestat
