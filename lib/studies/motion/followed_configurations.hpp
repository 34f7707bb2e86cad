// Where a motion is between its positions.
#pragma once

#include <map>
#include <optional>

#include "mechanism/mechanism.hpp"
#include "studies/motion/motion.hpp"

namespace kinestat {

/// Configurations of a motion at any share of its ranges, followed from the position before. Those
/// that were followed far are kept to start from, lest each of many follows many turns from there.
/// One a thread; the network and the motion must outlive it.
class FollowedConfigurations {
 public:
  FollowedConfigurations(const Mechanism& mechanism,
                         const MotionNetwork& network,
                         const MotionSolution& motion);

  /// At a share up to the last of the motion, and at that beyond it; empty where it cannot be
  /// followed.
  [[nodiscard]] std::optional<Configuration> at(double share);

 private:
  const MotionSolution& motion_;
  WayBetween way_;
  double far_;                             // a share that takes several steps to follow
  std::map<double, Configuration> known_;  // by the share: between the positions
};

}  // namespace kinestat
