#include "power/ratio.hpp"

#include <cmath>

#include "core/contract.hpp"
#include "core/tolerance.hpp"

namespace kinestat {

namespace {

// The rate of all inputs, or empty if they differ.
std::optional<double> common_rate(const Mechanism& mechanism,
                                  const Case& which,
                                  const KinematicSolution& motion) {
  std::optional<double> common;
  for (const int i : which.inputs) {
    const int freedom = mechanism.topology.actuators[static_cast<std::size_t>(i)].freedom;
    const double rate = motion.rates[static_cast<std::size_t>(freedom)];
    if (common && !(std::abs(rate - *common) <= kCancellation * std::abs(*common))) {
      return std::nullopt;
    }
    common = common.value_or(rate);
  }
  return common;
}

// The sum of the inputs' actions; empty if one of them is open, or a convention.
std::optional<double> total_action(const Mechanism& mechanism,
                                   const Case& which,
                                   const StaticSolution& action) {
  double sum = 0.0;
  for (const int i : which.inputs) {
    const int index = mechanism.topology.actuators[static_cast<std::size_t>(i)].action;
    const std::optional<double> magnitude = action.magnitudes[static_cast<std::size_t>(index)];
    if (!magnitude || is_by_convention(action, index)) {
      return std::nullopt;
    }
    sum += *magnitude;
  }
  return sum;
}

}  // namespace

Ratios find_ratios(const Mechanism& mechanism,
                   const Case& which,
                   const KinematicSolution& motion,
                   const StaticSolution* action) {
  KINESTAT_EXPECTS(!which.inputs.empty() && which.outputs.size() == 1);
  KINESTAT_EXPECTS(motion.status == SolveStatus::solved);
  const auto& actuators = mechanism.topology.actuators;
  const ActuatorTopology& output = actuators[static_cast<std::size_t>(which.outputs.front())];
  const std::optional<double> fast = common_rate(mechanism, which, motion);
  const double slow = motion.rates[static_cast<std::size_t>(output.freedom)];
  Ratios ratios;
  if (!fast) {
    ratios.reason = "the inputs have different rates";
    return ratios;
  }
  if (slow == 0.0) {
    ratios.reason = "output '" + output.name + "' is at rest";
  } else {
    ratios.ratio = *fast / slow;
  }
  if (action == nullptr) {
    return ratios;
  }
  const std::optional<double> in = total_action(mechanism, which, *action);
  const std::optional<double> out = action->magnitudes[static_cast<std::size_t>(output.action)];
  if (in && out && *out != 0.0 && !is_by_convention(*action, output.action)) {
    ratios.torque_ratio = *in / *out;
  }
  return ratios;
}

}  // namespace kinestat
