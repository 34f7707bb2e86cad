// The speed ratios of a torque converter at which a torque fits.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "mechanism/couplings/torque_converter.hpp"

namespace kinestat {

/// What was found between the ends of a characteristic.
struct FittingRatios {
  bool has_any = false;   ///< whether the torque has a value anywhere
  double least = 0.0;     ///< what it misses at least
  double greatest = 0.0;  ///< and at most
  std::vector<double> ratios = {};
};

/// What a torque is less what it should be; zero where that is rounding, so that ratios at which a
/// characteristic ends are found, as that of stall is.
double torque_miss(double torque, double asked);

/// Looks at nodes all over the characteristic, and between neighbours of other sign more closely.
class SpeedRatioScan {
 public:
  explicit SpeedRatioScan(const ConverterLaw& law);

  /// Rising, the same for all torques.
  const std::vector<double>& nodes() const { return nodes_; }

  /// `at_node` and `at` say by how much the torque misses at a node and at any speed ratio; empty
  /// where it has no value.
  FittingRatios run(const std::function<std::optional<double>(std::size_t)>& at_node,
                    const std::function<std::optional<double>(double)>& at) const;

 private:
  std::vector<double> nodes_;
};

}  // namespace kinestat
