#include "power/efficiency.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"

namespace kinestat {

namespace {

double sum_of(const std::vector<int>& chosen, const std::vector<double>& powers) {
  double sum = 0.0;
  for (const int i : chosen) {
    sum += powers[static_cast<std::size_t>(i)];
  }
  return sum;
}

// Whether all power comes from the inputs and goes to the outputs and into losses.
bool is_between_inputs_and_outputs(const Case& which,
                                   const std::vector<double>& actuators,
                                   const std::vector<double>& loads) {
  double largest = 0.0;
  double beside = 0.0;
  for (std::size_t i = 0; i < actuators.size(); ++i) {
    const int actuator = static_cast<int>(i);
    const bool is_named = std::ranges::find(which.inputs, actuator) != which.inputs.end() ||
                          std::ranges::find(which.outputs, actuator) != which.outputs.end();
    double& size = is_named ? largest : beside;
    size = std::max(size, std::abs(actuators[i]));
  }
  for (const double load : loads) {
    beside = std::max(beside, std::abs(load));
  }
  return beside <= kPowerBalance * largest;
}

}  // namespace

Efficiency find_efficiency(const Case& which,
                           const std::vector<double>& actuators,
                           const std::vector<double>& loads) {
  Efficiency result;
  if (which.inputs.empty() || which.outputs.empty()) {
    return result;
  }
  if (!is_between_inputs_and_outputs(which, actuators, loads)) {
    result.reason = "loads or other actuators exchange power too";
    return result;
  }
  const double in = sum_of(which.inputs, actuators);
  const double out = sum_of(which.outputs, actuators);
  result.is_self_locking = in > 0.0 && out > 0.0;
  if (in > 0.0 && out <= 0.0) {
    result.value = -out / in;
  } else {
    result.reason = result.is_self_locking ? "friction takes more than the inputs give"
                                           : "the inputs give no power";
  }
  return result;
}

}  // namespace kinestat
