// Where the freedoms of a network stand whose equations are evaluated.
#pragma once

#include <optional>
#include <vector>

#include "core/index.hpp"
#include "mechanism/mechanism.hpp"
#include "studies/motion/configuration.hpp"
#include "studies/motion/internal/closure_system.hpp"

namespace kinestat {

/// As `freedom_positions`; `system` is that of the network, evaluated in the configuration.
template <class Frames>
std::vector<std::optional<double>> freedom_positions_of(const ClosureSystem<Frames>& system,
                                                        const MotionNetwork& network,
                                                        const Mechanism& mechanism,
                                                        const Configuration& configuration) {
  std::vector<std::optional<double>> result(mechanism.topology.freedoms.size());
  std::vector<double> by_rate(at(network.rate_count), 0.0);
  for (const MotionJoint& joint : network.joints) {
    if (joint.coordinate < 0 || joint.motion.kind == ElementaryKind::ball) {
      continue;
    }
    const double value = configuration.coordinates[at(joint.coordinate)];
    by_rate[at(joint.rate)] = value;
    if (joint.freedom >= 0) {
      const double unit = joint.motion.kind == ElementaryKind::turn ? 1.0 : network.length;
      result[at(joint.freedom)] = value * unit;
    }
  }
  for (const MeasuredFreedom& one : network.measures) {
    result[at(one.freedom)] = one.measure.is_turn
                                  ? configuration.angles[at(one.angle)]
                                  : network.length * system.template position<double>(
                                                         system.in_sizes(one), system.frames());
  }
  for (const RollingRow& rolling : network.rollings) {
    const CouplingTopology& coupling = mechanism.topology.coupling(rolling.coupling);
    if (coupling.freedom_count != 1) {
      continue;
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < rolling.rates.size(); ++i) {
      sum += rolling.freedom_factors[i] * by_rate[at(rolling.rates[i])];
    }
    result[at(coupling.first_freedom)] = sum;
  }
  return result;
}

}  // namespace kinestat
