// A search for the speed ratios of a torque converter at which a torque has a given value.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "mechanism/couplings/torque_converter.hpp"

namespace kinestat {

/// The result of the search over a whole characteristic.
struct FittingRatios {
  bool has_any = false;   ///< whether the torque has a value at any node
  double least = 0.0;     ///< least difference from the given value [N·m]
  double greatest = 0.0;  ///< greatest difference [N·m]
  std::vector<double> ratios = {};
};

/// The difference of a torque from the given value; zero if it is within rounding, so that
/// solutions at the ends of the characteristic, such as stall, are found.
double torque_miss(double torque, double asked);

/// Evaluates the difference at nodes all over the characteristic, and finds the root between
/// neighbours with different signs.
class SpeedRatioScan {
 public:
  explicit SpeedRatioScan(const ConverterLaw& law);

  /// The speed ratios of the nodes, ascending; the same for all torques.
  const std::vector<double>& nodes() const { return nodes_; }

  /// Runs the search. `at_node` and `at` give the difference at a node and at any speed ratio;
  /// empty if the torque has no value there.
  FittingRatios run(const std::function<std::optional<double>(std::size_t)>& at_node,
                    const std::function<std::optional<double>(double)>& at) const;

 private:
  std::vector<double> nodes_;
};

}  // namespace kinestat
