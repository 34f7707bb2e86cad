#include "dynamics/spring_power.hpp"

#include <algorithm>

namespace kinestat {

double damping_loss(const Spring& spring, const SpringState& state) {
  const double damped = spring.damping * state.rate * state.rate;
  if (spring.acts == SpringSense::both || spring.is_of_freedom()) {
    return damped;
  }
  const bool has_force = spring.force.value != 0.0 || spring.force.law != nullptr;
  if (has_force) {
    return state.force == 0.0 ? 0.0 : damped;
  }
  return (state.force - elastic_tension(spring, state.position)) * state.rate;
}

std::vector<SpringPower> spring_powers(const Mechanism& mechanism,
                                       const std::vector<SpringState>& states,
                                       const std::vector<Load>& loads,
                                       std::span<const double> powers) {
  const std::vector<std::string> names = spring_load_names(mechanism);
  std::vector<SpringPower> result;
  if (names.empty() || states.empty()) {
    return result;
  }
  const auto first = std::ranges::find(loads, names.front(), &Load::name);
  auto at = static_cast<std::size_t>(first - loads.begin());
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Spring& spring = mechanism.springs[i];
    const std::size_t count =
        (spring.head.value != 0 ? 1U : 0U) + (spring.tail.value != 0 ? 1U : 0U);
    SpringPower one{.lost = damping_loss(spring, states[i]), .first = at, .load_count = count};
    one.given = one.lost;
    for (const double power : powers.subspan(at, count)) {
      one.given += power;
    }
    at += count;
    result.push_back(one);
  }
  return result;
}

}  // namespace kinestat
