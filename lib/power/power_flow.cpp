#include "power/power_flow.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "core/tolerance.hpp"

namespace kinestat {

namespace {

double input_power(const Case& which, const std::vector<double>& actuators) {
  double sum = 0.0;
  if (!which.inputs.empty()) {
    for (const int i : which.inputs) {
      sum += actuators[static_cast<std::size_t>(i)];
    }
    return sum;
  }
  for (const double power : actuators) {
    sum += std::max(power, 0.0);
  }
  return sum;
}

}  // namespace

PowerFlow find_power(const Mechanism& mechanism,
                     const Case& which,
                     const KinematicSolution& motion,
                     const StaticSolution& action) {
  KINESTAT_EXPECTS(motion.status == SolveStatus::solved && action.status == SolveStatus::solved);
  PowerFlow flow;
  double sum = 0.0;
  double largest = 0.0;
  for (std::size_t e = 0; e < mechanism.topology.couplings.size(); ++e) {
    const BodyId head = mechanism.topology.couplings[e].head;
    const Wrench& wrench = *action.wrenches[e];
    flow.into_head.push_back(power(wrench, motion.bodies[static_cast<std::size_t>(head.value)]));
    flow.supplied.push_back(power(wrench, motion.couplings[e]));
    sum += flow.supplied.back();
    largest = std::max({largest, std::abs(flow.into_head.back()), std::abs(flow.supplied.back())});
  }
  for (const ActuatorTopology& actuator : mechanism.topology.actuators) {
    flow.actuators.push_back(*action.magnitudes[static_cast<std::size_t>(actuator.action)] *
                             motion.rates[static_cast<std::size_t>(actuator.freedom)]);
  }
  flow.input = input_power(which, flow.actuators);
  flow.balance_residual = largest == 0.0 ? 0.0 : std::abs(sum) / largest;
  flow.is_balanced = flow.balance_residual <= kPowerBalance;
  return flow;
}

}  // namespace kinestat
