#include "power/efficiency.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/tolerance.hpp"
#include "power/internal/no_efficiency.hpp"

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
bool is_between_inputs_and_outputs(const Case& which, const CasePowers& powers) {
  double largest = 0.0;
  double beside = 0.0;
  for (std::size_t i = 0; i < powers.actuators.size(); ++i) {
    const int actuator = static_cast<int>(i);
    const bool is_named = std::ranges::find(which.inputs, actuator) != which.inputs.end() ||
                          std::ranges::find(which.outputs, actuator) != which.outputs.end();
    double& size = is_named ? largest : beside;
    size = std::max(size, std::abs(powers.actuators[i]));
  }
  for (const double load : powers.loads) {
    beside = std::max(beside, std::abs(load));
  }
  return beside <= kPowerBalance * largest;
}

// Whether one of them has a power of that sign, +1 or -1.
bool has_power(const std::vector<int>& chosen, double sign, const CasePowers& powers) {
  return std::ranges::any_of(chosen, [&](int i) {
    return sign * powers.actuators[static_cast<std::size_t>(i)] > kPowerBalance * powers.largest;
  });
}

}  // namespace

Efficiency find_efficiency(const Case& which, const CasePowers& powers) {
  if (which.inputs.empty() || which.outputs.empty()) {
    return {};
  }
  if (!is_between_inputs_and_outputs(which, powers)) {
    return no_efficiency("loads or other actuators exchange power too");
  }
  const double in = sum_of(which.inputs, powers.actuators);
  const double out = sum_of(which.outputs, powers.actuators);
  const double nothing = kReportZero * powers.largest;
  if (std::abs(in) <= nothing) {
    return no_efficiency("the inputs give no power");
  }
  if (in < 0.0) {
    return no_efficiency(out > nothing ? "the inputs take power, the outputs drive"
                                       : "the inputs take power");
  }
  if (has_power(which.inputs, -1.0, powers)) {
    return no_efficiency("one of the inputs takes power");
  }
  if (out > kPowerBalance * in) {
    return {.value = std::nullopt,
            .reason = "friction takes more than the inputs give",
            .is_self_locking = true};
  }
  if (has_power(which.outputs, 1.0, powers)) {
    return no_efficiency("one of the outputs gives power");
  }
  if (out >= -kPowerBalance * in) {
    return {.value = 0.0, .reason = "friction takes all that the inputs give"};
  }
  if (-out > (1.0 + kPowerBalance) * in) {
    return no_efficiency("the powers do not balance");
  }
  return {.value = std::min(-out / in, 1.0), .reason = ""};
}

}  // namespace kinestat
