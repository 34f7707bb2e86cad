#include "power/ratio.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "power/internal/bounded_magnitude.hpp"
#include "power/rate_ratio.hpp"

namespace kinestat {

namespace {

std::vector<double> input_rates(const Mechanism& mechanism,
                                const Case& which,
                                const KinematicSolution& motion) {
  std::vector<double> rates;
  for (const int i : which.inputs) {
    const int freedom = mechanism.topology.actuators[static_cast<std::size_t>(i)].freedom;
    rates.push_back(motion.rates[static_cast<std::size_t>(freedom)]);
  }
  return rates;
}

// The sum of the inputs' actions; empty if one of them is open, or a convention. Where several are
// summed, what they were rounded to as typed may be all that is left.
std::optional<BoundedNumber> total_action(const Mechanism& mechanism,
                                          const Case& which,
                                          const StaticSolution& action) {
  std::optional<BoundedNumber> sum;
  for (const int i : which.inputs) {
    const int index = mechanism.topology.actuators[static_cast<std::size_t>(i)].action;
    if (!action.magnitudes[static_cast<std::size_t>(index)] || is_by_convention(action, index)) {
      return std::nullopt;
    }
    const BoundedNumber one = bounded_action(action, index);
    sum = sum ? *sum + rounded_as_typed(one)
              : (which.inputs.size() == 1 ? one : rounded_as_typed(one));
  }
  return sum;
}

// Of ratios that have a value.
std::optional<double> bound_of_ratio(const Mechanism& mechanism,
                                     const Case& which,
                                     const KinematicSolution& motion) {
  if (!has_bounds(motion.answer)) {
    return std::nullopt;
  }
  const auto freedom = [&](int actuator) {
    return mechanism.topology.actuators[static_cast<std::size_t>(actuator)].freedom;
  };
  return (bounded_rate(motion, freedom(which.inputs.front())) /
          bounded_rate(motion, freedom(which.outputs.front())))
      .relative_bound();
}

}  // namespace

std::optional<double> common_rate(std::span<const double> rates) {
  const double first = rates.front();
  const bool is_common = std::ranges::all_of(rates, [&](double rate) {
    return std::abs(rate - first) <= kCancellation * std::abs(first);
  });
  return is_common ? std::optional(first) : std::nullopt;
}

std::optional<double> share_of(std::optional<double> above, std::optional<double> below) {
  return above && below && *below != 0.0 ? std::optional(*above / *below) : std::nullopt;
}

Ratios find_ratios(const Mechanism& mechanism,
                   const Case& which,
                   const KinematicSolution& motion,
                   const StaticSolution* action) {
  KINESTAT_EXPECTS(!which.inputs.empty() && which.outputs.size() == 1);
  KINESTAT_EXPECTS(motion.status == SolveStatus::solved);
  const auto& actuators = mechanism.topology.actuators;
  const ActuatorTopology& output = actuators[static_cast<std::size_t>(which.outputs.front())];
  const std::optional<double> fast = common_rate(input_rates(mechanism, which, motion));
  const double slow = motion.rates[static_cast<std::size_t>(output.freedom)];
  Ratios ratios;
  if (!fast) {
    ratios.reason = "the inputs have different rates";
    return ratios;
  }
  ratios.ratio = share_of(fast, slow);
  if (!ratios.ratio) {
    ratios.reason = "output '" + output.name + "' is at rest";
  } else {
    ratios.ratio_bound = bound_of_ratio(mechanism, which, motion);
  }
  if (action != nullptr) {
    add_torque_ratio(mechanism, which, *action, ratios);
  }
  return ratios;
}

void add_torque_ratio(const Mechanism& mechanism,
                      const Case& which,
                      const StaticSolution& action,
                      Ratios& ratios) {
  const ActuatorTopology& output =
      mechanism.topology.actuators[static_cast<std::size_t>(which.outputs.front())];
  const std::optional<BoundedNumber> in = total_action(mechanism, which, action);
  const bool has_output = action.magnitudes[static_cast<std::size_t>(output.action)] &&
                          !is_by_convention(action, output.action);
  if (!in || !has_output) {
    return;
  }
  const BoundedNumber out = bounded_action(action, output.action);
  ratios.torque_ratio = share_of(in->zeroed(), out.zeroed());
  const std::optional<double> advantage = share_of(out.zeroed(), in->zeroed());
  ratios.advantage = advantage ? std::optional(std::abs(*advantage)) : std::nullopt;
  if (ratios.torque_ratio && has_bounds(action.answer)) {
    ratios.torque_ratio_bound = (*in / out).relative_bound();
  }
}

}  // namespace kinestat
