// Sliders and inverted sliders that meet the positions best.
#pragma once

#include <span>
#include <vector>

#include "studies/synthesis/dyads/internal/precise_null_space.hpp"
#include "studies/synthesis/positions/plane.hpp"

namespace kinestat {

/// Which of the two points of a dyad lies at infinity: of a slider its centre.
enum class FarPoint { circle_point, centre };

/// In the units of a system of conditions.
struct StraightDyad {
  Point finite;                ///< the other point
  Point normal = {1.0, 0.0};   ///< direction of the far one, of length 1
  std::vector<double> misses;  ///< what is left of each condition
  double uncertainty = 0.0;    ///< by how much the allowances move points and direction

  /// By the sum of the squares, which the best fit has no larger than one within all allowances.
  bool is_within(std::span<const double> allowances) const;

  /// The largest miss, for conditions that change so much with a position that is moved by one.
  double deviation(std::span<const double> slopes) const;
};

/// Four conditions for the two coordinates of the finite point and the direction of the far one: by
/// Gauss and Newton the least sum of squares, each miss taken as a share of its `allowance`.
/// Starts from the given dyad.
StraightDyad fit_straight(std::span<const PreciseRow> rows,
                          std::span<const double> allowances,
                          FarPoint far,
                          StraightDyad start);

}  // namespace kinestat
