// The curvature of the path of a point, and how it changes.
#pragma once

#include <optional>

#include "studies/synthesis/positions/position_jets.hpp"

namespace kinestat {

/// K and its derivatives by the parameter of the position; those that its order leaves open are
/// empty. Positive where the path turns anticlockwise.
struct PathCurvature {
  std::optional<double> k;         ///< [1/length], order 3
  std::optional<double> k_prime;   ///< K' [1/length / t], order 4
  std::optional<double> k_second;  ///< K'' [1/length / t²], order 5
};

/// All empty where the point stands still (a cusp).
PathCurvature find_path_curvature(const PositionJets& position, const Point& moving);

}  // namespace kinestat
