#include "power/ratio.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "core/tolerance.hpp"

namespace kinestat {

namespace {

// The largest magnitude of the rates (or actions) of the same kind as the two compared: what counts
// as zero is measured against it.
bool is_zero(double value, double largest) {
  return std::abs(value) <= kReportZero * largest;
}

double largest_rate(const KinematicSolution& motion) {
  double largest = 0.0;
  for (const double rate : motion.rates) {
    largest = std::max(largest, std::abs(rate));
  }
  return largest;
}

double largest_action(const StaticSolution& action) {
  double largest = 0.0;
  for (const std::optional<double>& magnitude : action.magnitudes) {
    largest = std::max(largest, std::abs(magnitude.value_or(0.0)));
  }
  return largest;
}

// The rate of all inputs, or empty if they differ.
std::optional<double> common_rate(const Mechanism& mechanism,
                                  const Case& which,
                                  const KinematicSolution& motion) {
  std::optional<double> common;
  for (const int i : which.inputs) {
    const int freedom = mechanism.topology.actuators[static_cast<std::size_t>(i)].freedom;
    const double rate = motion.rates[static_cast<std::size_t>(freedom)];
    if (common && !is_zero(rate - *common, largest_rate(motion))) {
      return std::nullopt;
    }
    common = common.value_or(rate);
  }
  return common;
}

// The sum of the inputs' actions; empty if equilibrium does not determine one of them.
std::optional<double> total_action(const Mechanism& mechanism,
                                   const Case& which,
                                   const StaticSolution& action) {
  double sum = 0.0;
  for (const int i : which.inputs) {
    const int index = mechanism.topology.actuators[static_cast<std::size_t>(i)].action;
    const std::optional<double> magnitude = action.magnitudes[static_cast<std::size_t>(index)];
    if (!magnitude) {
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
  if (is_zero(slow, largest_rate(motion))) {
    ratios.reason = "output '" + output.name + "' is at rest";
  } else {
    ratios.ratio = *fast / slow;
  }
  if (action == nullptr) {
    return ratios;
  }
  const std::optional<double> in = total_action(mechanism, which, *action);
  const std::optional<double> out = action->magnitudes[static_cast<std::size_t>(output.action)];
  if (in && out && !is_zero(*out, largest_action(*action))) {
    ratios.torque_ratio = *in / *out;
  }
  return ratios;
}

}  // namespace kinestat
