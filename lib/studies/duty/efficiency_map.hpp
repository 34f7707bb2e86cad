// The efficiency of a case over the speed and the load of its input.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "studies/duty/duty_solution.hpp"

namespace kinestat {

/// From `low`, which is not positive, to `high`, which is not negative [SI].
struct MapRange {
  double low = 0.0;
  double high = 0.0;
};

/// Where a duty is for a while.
struct MapPoint {
  double speed = 0.0;     ///< of the input [rad/s or m/s]
  double load = 0.0;      ///< of the input [N·m or N]
  double duration = 0.0;  ///< [s]
};

/// Efficiencies with all losses in the middle of kMapRows times kMapColumns cells.
struct EfficiencyMap {
  std::size_t which = 0;  ///< index into Mechanism::cases
  int input = 0;          ///< actuator
  MapRange speeds;
  MapRange loads;
  /// Row by row from the lowest load. Empty where losses take all that is given, so that the output
  /// drives too, or where there is no answer.
  std::vector<std::optional<double>> cells;
  std::vector<MapPoint> points;  ///< that move, in the order of the duty

  /// Of all cells, where it hangs on neither speed nor load.
  std::optional<double> constant() const;
};

inline constexpr std::size_t kMapColumns = 24;
inline constexpr std::size_t kMapRows = 16;

/// Of each case of a duty that has one input whose speed and load are known, from zero to the
/// largest speed and load of its points, to both sides where these are; other magnitudes are those
/// of the case.
std::vector<EfficiencyMap> map_duty(const Mechanism& mechanism, const DutyPlan& plan);

/// Of these cases, likewise, a quarter beyond their own speed and load.
std::vector<EfficiencyMap> map_cases(const Mechanism& mechanism,
                                     std::span<const std::size_t> cases);

}  // namespace kinestat
