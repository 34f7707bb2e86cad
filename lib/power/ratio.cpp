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

}  // namespace

Ratios find_ratios(const Mechanism& mechanism,
                   const Case& which,
                   const KinematicSolution& motion,
                   const StaticSolution* action) {
  KINESTAT_EXPECTS(which.inputs.size() == 1 && which.outputs.size() == 1);
  KINESTAT_EXPECTS(motion.status == SolveStatus::solved);
  const auto& actuators = mechanism.topology.actuators;
  const ActuatorTopology& input = actuators[static_cast<std::size_t>(which.inputs.front())];
  const ActuatorTopology& output = actuators[static_cast<std::size_t>(which.outputs.front())];
  Ratios ratios;
  const double slow = motion.rates[static_cast<std::size_t>(output.freedom)];
  if (is_zero(slow, largest_rate(motion))) {
    ratios.reason = "output '" + output.name + "' is at rest";
  } else {
    ratios.ratio = motion.rates[static_cast<std::size_t>(input.freedom)] / slow;
  }
  if (action == nullptr) {
    return ratios;
  }
  const std::optional<double> in = action->magnitudes[static_cast<std::size_t>(input.action)];
  const std::optional<double> out = action->magnitudes[static_cast<std::size_t>(output.action)];
  if (in && out && !is_zero(*out, largest_action(*action))) {
    ratios.torque_ratio = *in / *out;
  }
  return ratios;
}

}  // namespace kinestat
