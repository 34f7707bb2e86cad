#include "power/efficiency.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/rounding.hpp"
#include "couplings/kinds.hpp"
#include "math/numbers/bounded_number.hpp"
#include "power/internal/no_efficiency.hpp"

namespace kinestat {

namespace {

// Zero where rounding of its own terms does not tell it from zero; the terms are what they are.
double sum_of(const std::vector<int>& chosen, const std::vector<double>& powers) {
  BoundedNumber sum;
  for (const int i : chosen) {
    const double power = powers[static_cast<std::size_t>(i)];
    sum = sum + BoundedNumber{.value = power, .bound = kSolvedRounding * std::abs(power)};
  }
  return sum.zeroed();
}

// Whether all power comes from the inputs and goes to the outputs and into losses.
bool is_between_inputs_and_outputs(const Case& which, const CasePowers& powers) {
  double largest = 0.0;
  double beside = 0.0;
  for (std::size_t i = 0; i < powers.actuators.size(); ++i) {
    const int actuator = static_cast<int>(i);
    const bool is_named = std::ranges::find(which.inputs, actuator) != which.inputs.end() ||
                          std::ranges::find(which.outputs, actuator) != which.outputs.end();
    const bool slips = powers.slips != nullptr && (*powers.slips)[i];
    if (!is_named && slips && powers.actuators[i] <= 0.0) {
      continue;
    }
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

std::vector<bool> find_slipping(const Topology& topology) {
  std::vector<bool> slips;
  for (const ActuatorTopology& actuator : topology.actuators) {
    const auto freedom = static_cast<std::size_t>(actuator.freedom);
    const CouplingType type = topology.coupling(topology.freedoms[freedom].coupling).type;
    slips.push_back(kind_of(type).engages);
  }
  return slips;
}

Efficiency find_efficiency(const Case& which, const CasePowers& powers) {
  if (which.inputs.empty() || which.outputs.empty()) {
    return {};
  }
  if (!is_between_inputs_and_outputs(which, powers)) {
    return no_efficiency("loads or other actuators exchange power too");
  }
  const double in = sum_of(which.inputs, powers.actuators);
  const double out = sum_of(which.outputs, powers.actuators);
  if (in == 0.0) {
    return no_efficiency("the inputs give no power");
  }
  if (in < 0.0) {
    return no_efficiency(out > 0.0 ? "the inputs take power, the outputs drive"
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
  if (out >= 0.0) {
    return {.value = 0.0, .reason = "friction takes all that the inputs give"};
  }
  if (-out > (1.0 + kPowerBalance) * in) {
    return no_efficiency("the powers do not balance");
  }
  return {.value = std::min(-out / in, 1.0), .reason = ""};
}

}  // namespace kinestat
