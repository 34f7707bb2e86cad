#include "power/efficiency.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/rounding.hpp"
#include "core/text.hpp"
#include "couplings/kinds.hpp"
#include "math/numbers/bounded_number.hpp"
#include "mechanism/cases/load.hpp"
#include "power/internal/no_efficiency.hpp"
#include "power/stored_power.hpp"

namespace kinestat {

namespace {

// What the inputs or the outputs of a case give.
std::vector<double> powers_of(const std::vector<int>& actuators,
                              const std::vector<std::size_t>& loads,
                              const CasePowers& powers) {
  std::vector<double> result;
  for (const int i : actuators) {
    result.push_back(powers.actuators[static_cast<std::size_t>(i)]);
  }
  for (const std::size_t i : loads) {
    result.push_back(powers.loads[i]);
  }
  return result;
}

// Zero where rounding of its own terms does not tell it from zero; the terms are what they are.
double sum_of(const std::vector<double>& powers) {
  BoundedNumber sum;
  for (const double power : powers) {
    sum = sum + BoundedNumber{.value = power, .bound = kSolvedRounding * std::abs(power)};
  }
  return sum.zeroed();
}

template <class Index>
bool holds(const std::vector<Index>& first, const std::vector<Index>& second, std::size_t i) {
  const auto index = static_cast<Index>(i);
  return std::ranges::find(first, index) != first.end() ||
         std::ranges::find(second, index) != second.end();
}

// Those that are neither input nor output; which of the two turns round where the outputs drive.
std::vector<std::string> loads_beside(const Case& which,
                                      const CasePowers& powers,
                                      double negligible) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < powers.loads.size(); ++i) {
    if (!holds(which.input_loads, which.output_loads, i) &&
        stored_power_reason(which.loads[i]).empty() && std::abs(powers.loads[i]) > negligible) {
      names.push_back(fmt::format("'{}'", which.loads[i].name));
    }
  }
  return names;
}

// "loads 'F', 'G'".
std::string named(std::string_view kind, const std::vector<std::string>& names) {
  return fmt::format("{}{} {}", kind, names.size() == 1 ? "" : "s", plain_list(names));
}

// "actuator 'fan' and loads 'F', 'G' also supply or absorb power; list them under 'input' or
// 'output'".
std::string exchange_text(const std::vector<std::string>& actuators,
                          const std::vector<std::string>& loads) {
  const bool is_one = actuators.size() + loads.size() == 1;
  return fmt::format("{}{}{} also {} power; list {} under 'input' or 'output'",
                     actuators.empty() ? "" : named("actuator", actuators),
                     actuators.empty() || loads.empty() ? "" : " and ",
                     loads.empty() ? "" : named("load", loads),
                     is_one ? "supplies or absorbs" : "supply or absorb",
                     is_one ? "it" : "them");
}

// Why not all power comes from the inputs and goes to the outputs and into losses; empty if it
// does.
std::string exchange_beside(const Topology& topology, const Case& which, const CasePowers& powers) {
  double largest = 0.0;
  double beside = 0.0;
  std::vector<std::size_t> actuators;
  for (std::size_t i = 0; i < powers.actuators.size(); ++i) {
    const bool is_named = holds(which.inputs, which.outputs, i);
    if (!is_named && powers.actuators[i] <= 0.0 && is_shift_element(topology, i)) {
      continue;
    }
    if (!is_named) {
      actuators.push_back(i);
    }
    double& size = is_named ? largest : beside;
    size = std::max(size, std::abs(powers.actuators[i]));
  }
  const Load* load = nullptr;
  for (std::size_t i = 0; i < powers.loads.size(); ++i) {
    const double power = std::abs(powers.loads[i]);
    const bool is_named = holds(which.input_loads, which.output_loads, i);
    load = !is_named && power > beside ? &which.loads[i] : load;
    double& size = is_named ? largest : beside;
    size = std::max(size, power);
  }
  const double negligible = kPowerBalance * largest;
  if (beside <= negligible) {
    return {};
  }
  if (load != nullptr && !stored_power_reason(*load).empty()) {
    return stored_power_reason(*load);
  }
  std::vector<std::string> exchanging;
  for (const std::size_t i : actuators) {
    if (std::abs(powers.actuators[i]) > negligible) {
      exchanging.push_back(fmt::format("'{}'", topology.actuators[i].name));
    }
  }
  return exchange_text(exchanging, loads_beside(which, powers, negligible));
}

// Whether one of them has a power of that sign, +1 or -1.
bool has_power(const std::vector<double>& chosen, double sign, const CasePowers& powers) {
  return std::ranges::any_of(
      chosen, [&](double power) { return sign * power > kPowerBalance * powers.largest; });
}

}  // namespace

bool is_shift_element(const Topology& topology, std::size_t actuator) {
  const auto freedom = static_cast<std::size_t>(topology.actuators[actuator].freedom);
  return kind_of(topology.coupling(topology.freedoms[freedom].coupling).type).engages;
}

Efficiency find_efficiency(const Topology& topology, const Case& which, const CasePowers& powers) {
  if (!which.names_both_ends()) {
    return {};
  }
  if (std::string reason = exchange_beside(topology, which, powers); !reason.empty()) {
    return no_efficiency(std::move(reason));
  }
  const std::vector<double> inputs = powers_of(which.inputs, which.input_loads, powers);
  const std::vector<double> outputs = powers_of(which.outputs, which.output_loads, powers);
  const double in = sum_of(inputs);
  const double out = sum_of(outputs);
  if (in == 0.0) {
    return no_efficiency("the inputs supply no power");
  }
  if (in < 0.0) {
    return no_efficiency(out > 0.0 ? "the inputs absorb power: the outputs drive"
                                   : "the inputs absorb power");
  }
  if (has_power(inputs, -1.0, powers)) {
    return no_efficiency("one of the inputs absorbs power");
  }
  if (out > kPowerBalance * in) {
    return {.value = std::nullopt,
            .reason = "friction absorbs more power than the inputs supply",
            .is_self_locking = true};
  }
  if (has_power(outputs, 1.0, powers)) {
    return no_efficiency("one of the outputs supplies power");
  }
  if (out >= 0.0) {
    return {.value = 0.0, .reason = "friction absorbs all power of the inputs"};
  }
  if (-out > (1.0 + kPowerBalance) * in) {
    return no_efficiency("the powers do not balance");
  }
  return {.value = std::min(-out / in, 1.0), .reason = ""};
}

}  // namespace kinestat
